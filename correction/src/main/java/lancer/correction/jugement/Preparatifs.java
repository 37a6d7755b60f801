package lancer.correction.jugement;

import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.TestInstancePostProcessor;

/** Fait, avant une vérification, ce que demandent ses champs : s'ils ne peuvent être construits, elle ne commence pas. */
public final class Preparatifs implements TestInstancePostProcessor {

    @Override
    public void postProcessTestInstance(Object verification, ExtensionContext contexte) {
        Dialogue.achever();
    }
}
