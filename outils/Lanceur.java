import java.io.PrintWriter;
import org.junit.platform.engine.discovery.DiscoverySelectors;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;
import org.junit.platform.launcher.listeners.SummaryGeneratingListener;

/** Ce que fait un environnement de développement pour lancer une classe de tests. */
final class Lanceur {

    private Lanceur() {
    }

    /** @param args le nom de la classe */
    public static void main(String[] args) {
        SummaryGeneratingListener bilan = new SummaryGeneratingListener();
        LauncherFactory.create().execute(LauncherDiscoveryRequestBuilder.request()
                .selectors(DiscoverySelectors.selectClass(args[0])).build(), bilan);
        bilan.getSummary().printTo(new PrintWriter(System.out));
        System.exit(bilan.getSummary().getTotalFailureCount() == 0 ? 0 : 1);
    }
}
