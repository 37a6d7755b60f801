package lancer.fenetre.vue;

import java.text.ParseException;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JFormattedTextField;
import javax.swing.text.InternationalFormatter;
import lancer.fenetre.etat.Suite;

/** Une valeur à taper, proposée par Entrée ou en quittant le champ. Refusée, elle y reste ; Échap rend la présente. */
@SuppressWarnings("serial")
final class Champ extends JFormattedTextField {

    private final Consumer<Suite.Evenement> recevoir;
    private final Function<String, Suite.Evenement> changement;

    /** @param changement ce qui arrive quand ce texte est proposé */
    Champ(int colonnes, Consumer<Suite.Evenement> recevoir, Function<String, Suite.Evenement> changement) {
        super(new InternationalFormatter());
        this.recevoir = recevoir;
        this.changement = changement;
        setColumns(colonnes);
        setFocusLostBehavior(COMMIT);
    }

    /** Montre cette valeur. Ce qui s'écrit reste, tant qu'elle est la même. */
    void montrer(String presente) {
        if (!presente.equals(getValue())) {
            setValue(presente);
            setCaretPosition(0);
        }
    }

    @Override
    public void commitEdit() throws ParseException {
        String voulue = getText().trim();
        recevoir.accept(voulue.equals(getValue()) ? Suite::oublierLeRefus : changement.apply(voulue));
        // une valeur acceptée s'est déjà montrée
        if (!getText().trim().equals(getValue())) {
            throw new ParseException(voulue, 0);
        }
    }
}
