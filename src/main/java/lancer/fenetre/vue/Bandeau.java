package lancer.fenetre.vue;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.Timer;
import javax.swing.UIManager;
import lancer.fenetre.etat.Etat;
import lancer.fenetre.etat.Suite;
import lancer.texte.Texte;

/** Messages de la fenêtre, sur le bas de l'image : ce qui a changé sur le disque, les fautes, puis un avis. */
@SuppressWarnings("serial")
final class Bandeau extends Etiquette implements Vue {

    private static final int DUREE_AVIS_MS = 8000;
    private static final int MARGE = 6;

    private final Timer oubli;
    private Etat.Avis avis;

    Bandeau(Consumer<Suite.Evenement> recevoir) {
        super("message");
        setOpaque(true);
        setVisible(false);
        setToolTipText("cliquer pour fermer");
        oubli = new Timer(DUREE_AVIS_MS, e -> {
            Etat.Avis lu = avis;
            recevoir.accept(suite -> suite.oublier(lu));
        });
        oubli.setRepeats(false);
        addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                recevoir.accept(Suite::fermerLeMessage);
            }
        });
    }

    @Override
    public void montrer(Etat etat) {
        if (etat.avis != avis) {
            avis = etat.avis;
            oubli.stop();
            if (avis.passe() && !avis.texte.isEmpty()) {
                oubli.restart();
            }
        }
        Stream<String> graves = Stream.concat(Stream.of(etat.getAlerte()), etat.getFautesALire().stream());
        String texte = Stream.concat(graves, Stream.of(avis.texte)).filter(dit -> !dit.isEmpty())
                .flatMap(dit -> Stream.of(dit.split("\n"))).map(Texte::echappe).distinct()
                .collect(Collectors.joining("\n"));
        boolean grave = !etat.getAlerte().isEmpty() || !etat.getFautesALire().isEmpty() || !avis.passe();
        setBackground(UIManager.getColor("ToolTip.background"));
        setForeground(UIManager.getColor("ToolTip.foreground"));
        setBorder(BorderFactory.createCompoundBorder(BorderFactory.createMatteBorder(0, MARGE, 0, 0,
                UIManager.getColor("Component." + (grave ? "error" : "warning") + ".focusedBorderColor")),
                BorderFactory.createEmptyBorder(MARGE, MARGE, MARGE, MARGE)));
        setText(texte);
        setVisible(!texte.isEmpty());
    }
}
