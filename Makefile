include commun.mk

N ?= 1000000
# L'écran des tests de la fenêtre, qui n'est pas celui de l'utilisateur ; rien là où Xvfb manque.
ifneq ($(and $(shell command -v xvfb-run),$(shell command -v Xvfb),$(shell command -v xauth)),)
XVFB := xvfb-run -a -s "-screen 0 1280x800x24"
endif
# Vide, ces tests sont laissés de côté ; FENETRES=exigees les fait là où Xvfb manque aussi, sur l'écran de l'utilisateur.
FENETRES ?= $(if $(XVFB),exigees)
RAPPORTS := . -path '*/surefire-reports/TEST-*.xml'

.PHONY: test application lanceurs javadoc images references captures scene-geante noyaux mesures juge mesure-auto mutations squelette \
	corrige corriger profil-bwrap noter comparer reponses mesure-corriger image-classe aide propre

# Tout, tous modules, un par cœur s'ils ne s'attendent pas. Maven dit où il en est, module par module et classe par classe.
test: outils $(LISTES)
	@echo "Tous les tests : sept minutes environ sur deux cœurs"
	@find $(RAPPORTS) -delete
	$(XVFB) $(MVN) -T 1C -f ensemble.xml $(if $(FENETRES),-Dfenetre.exigee=true -Djava.awt.headless=false) verify
	@$(if $(FENETRES),,echo "$$(find $(RAPPORTS) -exec cat {} + | grep -c '<skipped .*ouvre une fenêtre')" \
	    "tests laissés de côté, tous ceux qui ouvrent une fenêtre ; les autres sont faits." && \
	    echo "Pour les avoir : sudo apt-get install xvfb xauth, puis make test")

# Un programme qui se lance sans JDK : sa machine virtuelle, ses options et, avec VARIANTES="brume blinn", les variantes. Celle d'une image
# par processus, dont l'archive de classes est refaite : sans elle, Java démarre deux fois plus lentement.
APPLICATION := target/lancer
application: $(JARS)
	@command -v jpackage >/dev/null || { echo "Il faut jpackage, que contient un JDK 14 ou plus récent : sudo apt-get install default-jdk" >&2; exit 1; }
	@rm -rf $(APPLICATION) target/application && mkdir -p target/application && cp $(JARS) target/application
	@jpackage --type app-image --name $(notdir $(APPLICATION)) --dest $(dir $(APPLICATION)) --input target/application \
	    --main-jar $(notdir $(firstword $(JARS))) --main-class lancer.Main --add-modules java.desktop,java.logging,jdk.localedata \
	    --jlink-options "--strip-debug --no-man-pages --no-header-files --include-locales=fr" \
	    $(OPTIONS_IMAGE:%=--java-options %)
	@$(APPLICATION)/lib/runtime/bin/java -Xshare:dump >/dev/null && rm -r $(APPLICATION)/lib/runtime/bin
	@echo "$(APPLICATION)/bin/lancer : le programme et sa machine virtuelle, $$(du -sh $(APPLICATION) | cut -f1)"

# La Javadoc de chaque module, dans son dossier target/reports/apidocs.
javadoc: outils
	@$(MVN) -q -f ensemble.xml -DskipTests package javadoc:javadoc

# lancer.Tests par les lanceurs JUnit des environnements de développement, et par les consoles des mêmes versions.
lanceurs: outils
	@MVN="$(MVN)" JAVA="$(JAVA)" outils/lanceurs.sh

VARIANTES_TOUTES := brume antialias blinn
MODULES := . mesures $(VARIANTES_TOUTES)

mesures/target/mesures.jar: ensemble.xml $(MODULES:%=%/pom.xml) $(foreach m,$(MODULES),$(call sources,$(m))) | outils
	$(DIRE)
	@$(MVN) -q -f ensemble.xml -pl :mesures -am -DskipTests package
	@touch $@

# Met à jour le dossier $(2) par les images de $(1). Celles dont aucun pixel n'a changé gardent leurs octets, qui dépendent de la machine.
actualiser = for nom in $$(cd $(1) && ls *.png); do \
	    $(JAVA_IMAGE) -jar $(BASE) --comparer $(1)/$$nom $(2)/$$nom >/dev/null 2>&1 || { cp $(1)/$$nom $(2) && echo "changée : $$nom"; } || exit 1; \
	done

# Les images des pages, et l'icône de la fenêtre.
SCENES := scene1 diffus ombres miroirs bowling tournesol
NEUVES := target/images

images: $(BASE) $(foreach v,$(VARIANTES_TOUTES),$(v)/target/$(v).jar)
	@rm -rf $(NEUVES) && mkdir -p $(NEUVES)
	@for s in $(SCENES); do \
	    reflets=5; [ $$s = miroirs ] && reflets=40; \
	    $(JAVA_IMAGE) -jar $(BASE) --reflets $$reflets --image $(NEUVES)/$$s.png scenes/$$s.ini || exit 1; \
	done
	@$(JAVA_IMAGE) -jar $(BASE) --image $(NEUVES)/brume-sans.png scenes/brume.ini 2>/dev/null
	@$(JAVA_IMAGE) -jar brume/target/brume.jar --image $(NEUVES)/brume-avec.png scenes/brume.ini
	@$(JAVA_IMAGE) -jar blinn/target/blinn.jar --image $(NEUVES)/blinn-avec.png scenes/bowling.ini
	@$(JAVA_IMAGE) -jar $(BASE) --taille 200x150 --image $(NEUVES)/antialias-sans.png scenes/scene1.ini
	@$(JAVA_IMAGE) -jar antialias/target/antialias.jar --taille 200x150 --image $(NEUVES)/antialias-avec.png scenes/scene1.ini
	@{ cat scenes/scene1.ini; printf '\n[Antialias]\nmethode=partage\nn=8\nseuil=0.06\n'; } > target/partage.ini
	@$(JAVA_IMAGE) -jar antialias/target/antialias.jar --taille 400x300 --vue rayons --image $(NEUVES)/vue-rayons.png target/partage.ini
	@$(JAVA_IMAGE) -jar antialias/target/antialias.jar --taille 400x300 --vue difference --image $(NEUVES)/vue-difference.png scenes/scene1.ini
	@$(MVN) -q -f ensemble.xml -pl :lancer test-compile
	@$(JAVA_IMAGE) -cp $(BASE):target/test-classes lancer.essai.Defauts $(NEUVES)
	@$(call actualiser,$(NEUVES),images)
	@mkdir $(NEUVES)/icones
	@for c in 16 32 48 128; do \
	    $(JAVA_IMAGE) -jar antialias/target/antialias.jar --taille $${c}x$$c --image $(NEUVES)/icones/icone-$$c.png scenes/scene1.ini || exit 1; \
	done
	@$(call actualiser,$(NEUVES)/icones,src/main/resources/lancer/fenetre)

# Les images de référence des tests dont l'image du programme s'écarte : après un changement voulu, celle-ci prend leur place.
references: outils
	@$(MVN) -q -f ensemble.xml -pl :lancer,:brume,:blinn,:antialias -Dgroups=reference -Dreferences.refaites=true test

# Les captures d'écran des pages, sur un écran à elles.
captures: $(BASE) blinn/target/blinn.jar
	@$(if $(XVFB),,echo "Il faut Xvfb : sudo apt-get install xvfb xauth" >&2; exit 1)
	@rm -rf target/captures && mkdir -p target/captures
	@$(MVN) -q -f ensemble.xml -pl :lancer test-compile
	@$(call capture,1248x702,blinn,fenetre-reglages) "Réglages" Blinn "" --sans=Brume,Antialias scenes/bowling.ini
	@$(call capture,1248x702,blinn,inspecteur) 405,360 verdict "Au bit près" --sans=Blinn scenes/scene1.ini
	@$(call capture,940x490,blinn,vitesse-ou-precision) "Vitesse ou précision" vitesse.etat "un clic" --sans=Blinn --taille=500x400 scenes/scene1.ini
	@$(call actualiser,target/captures,images)
capture = xvfb-run -a -s "-screen 0 $(1)x24 -wr" $(JAVA_FENETRE) \
	-cp $(2)/target/$(2).jar:target/test-classes lancer.fenetre.Captures target/captures/$(3).png

# Une scène de N boules, ou une scène difficile (N=poussiere, ombres-fines, poussiere-miroirs) : make run SCENE=target/geante.ini
scene-geante: mesures/target/mesures.jar
	@mkdir -p target
	@$(JAVA) -cp mesures/target/mesures.jar lancer.mesures.scenes.Foule $(N) > target/geante.tmp && mv target/geante.tmp target/geante.ini
	@echo "target/geante.ini : $(N), $$(wc -c < target/geante.ini) octets"

# Le temps de chaque façon de calculer une intersection, et la courbe des méthodes.
noyaux: mesures/target/mesures.jar
	@$(JAVA) -cp mesures/target/mesures.jar lancer.mesures.vitesse.Vitesse --noyaux

# Les courbes de vitesse et de précision, de mesures faites maintenant. Interrompue ou refusée, elle ne change rien à mesures/resultats.
# MESURES=--dessiner refait les courbes des mesures de mesures/resultats, sans mesurer ; MESURES=--comptes mesure tout ce qui ne se
# chronomètre pas, si chargée que soit la machine, et MESURES=--temps le reste ; MESURES=--stabilite ne mesure que la stabilité.
mesures: mesures/target/mesures.jar $(BASE) $(foreach v,$(VARIANTES_TOUTES),$(v)/target/$(v).jar) | mesures/target/embree
	@$(JAVA) -cp mesures/target/mesures.jar lancer.mesures.vitesse.Vitesse $(if $(filter-out 0 non,$(RAPIDE)),--rapide) $(MESURES)

# Un pair en C++, pour les mesures.
mesures/target/embree: mesures/src/main/cpp/embree.cpp
	@g++ -O3 -march=native -pthread -o $@ $< -lembree3 2>/dev/null || echo "Sans Embree : sudo apt-get install g++ libembree-dev"

# Les mêmes scènes dessinées par POV-Ray ; JUGE="--reflets 3 target/geante.ini" pour d'autres.
juge: mesures/target/mesures.jar
	@$(JAVA) -cp mesures/target/mesures.jar lancer.mesures.juge.Juge $(JUGE)

# --auto tient-il parole, et à quel prix ? Contre toute l'échelle dessinée, en quatre minutes.
mesure-auto: mesures/target/mesures.jar
	@$(JAVA) -cp mesures/target/mesures.jar lancer.mesures.vitesse.MesureAuto mesures/resultats/auto.csv
	@$(JAVA) -cp mesures/target/mesures.jar lancer.mesures.vitesse.Vitesse --dessiner

# Des fautes mises exprès dans l'arithmétique, par PIT : combien les tests rapides en voient.
PIT := $(patsubst %,%/target/pit-reports,. $(VARIANTES_TOUTES))

mutations: outils
	@rm -rf $(PIT) && mkdir -p target
	@echo "Un millier de fautes, l'une après l'autre : six à huit minutes"
	@nice -n 19 $(MVN) -q -f ensemble.xml -Pmutations -pl :lancer,:brume,:blinn,:antialias \
	    test-compile org.pitest:pitest-maven:mutationCoverage > target/mutations.log 2>&1 || { cat target/mutations.log >&2; exit 1; }
	@cat $(PIT:=/mutations.csv) | awk -F, '$$6 != "SURVIVED" && $$6 != "NO_COVERAGE" { vues++ } \
	    END { printf "%d fautes vues sur %d, soit %d %%\n", vues, NR, 100 * vues / NR }'
	@echo "Ligne par ligne : $(PIT:=/index.html)"

CORRECTION := correction/target/correction.jar
# il ne dure pas : compiler à fond coûterait de la mémoire sans rien gagner (make mesure-corriger)
CORRIGER = $(JAVA) -XX:TieredStopAtLevel=1 -XX:+UseSerialGC -jar $(CORRECTION)
$(CORRECTION): ensemble.xml correction/pom.xml src/test/java/lancer/Tests.java $(call sources,correction) \
	$(shell find correction/src/modele correction/src/sondes -type f) $(wildcard scenes/*.ini) \
	$(foreach c,Tuple Couleur Lampe PointContact,src/main/java/lancer/$(c).java) | outils
	$(DIRE)
	@$(MVN) -q -f ensemble.xml -pl :correction -am -DskipTests package
	@touch $@

# Les figures et les nombres de docs/reponses.md.
reponses: $(BASE) mesures/target/mesures.jar
	@rm -rf target/reponses && mkdir -p target/reponses
	@$(JAVA) -cp mesures/target/mesures.jar:mesures/target/test-classes lancer.mesures.pages.Reponses docs/reponses.md target/reponses
	@cp target/reponses/*.svg images
	@$(call actualiser,target/reponses,images)

# Deux images, ou une image et une scène : make comparer A=attendue.png B=scenes/scene1.ini ; statut 0 si elles sont pareilles.
comparer: $(BASE)
	@test -n "$(A)" -a -n "$(B)" || { echo "Que comparer ? make comparer A=attendue.png B=autre.png (ou une scène)" >&2; exit 2; }
	@dit=$$($(JAVA_IMAGE) -jar $(BASE) $(OPTIONS) --comparer "$(A)" "$(B)"); statut=$$?; echo "$$dit"; \
	case "$$statut $$dit" in \
	    "1 images: "*) echo "make comparer : les images sont différentes" >&2;; \
	    1*) echo "make comparer : la machine n'a pas pu, rien n'est comparé" >&2;; \
	    2*) echo "make comparer : demande fausse, rien n'est comparé" >&2;; \
	esac; exit $$statut

# Le projet que reçoivent les étudiants : make squelette DOSSIER=../lancer-base
squelette: $(CORRECTION)
	@test -n "$(DOSSIER)" || { echo "Où l'écrire ? make squelette DOSSIER=../lancer-base" >&2; exit 2; }
	@$(JAVA) -jar $(CORRECTION) --squelette "$(DOSSIER)"

# Le programme achevé du cours : make corrige DOSSIER=../base-java ; VARIANTE=brume (ou antialias, blinn) : la copie d'une extension.
corrige: $(CORRECTION)
	@test -n "$(DOSSIER)" || { echo "Où l'écrire ? make corrige DOSSIER=../base-java [VARIANTE=brume]" >&2; exit 2; }
	@$(JAVA) -jar $(CORRECTION) --corrige "$(DOSSIER)" $(if $(VARIANTE),--variante "$(VARIANTE)")

# Juger et noter une classe : make corriger RENDUS=rendus.zip NOTES=notes.csv ; SANS_CONFINEMENT=1 là où bwrap ne marche pas.
# AJOUTER=1 : les rendus donnés s'ajoutent à ceux qui ont été jugés, ou les remplacent ; les autres restent.
corriger: $(CORRECTION)
	@test -n "$(RENDUS)" || { echo "Quels rendus ? make corriger RENDUS=dossier-ou-archive.zip [NOTES=feuille.csv] [AJOUTER=1]" >&2; exit 2; }
	@$(CORRIGER) $(if $(NOTES),--notes "$(NOTES)") $(if $(BAREME),--bareme "$(BAREME)") $(if $(SORTIE),--sortie "$(SORTIE)") \
	    $(if $(filter-out 0 non,$(AJOUTER)),--ajouter) $(if $(filter-out 0 non,$(SANS_CONFINEMENT)),--sans-confinement) "$(RENDUS)"

# Le profil AppArmor dont bwrap a besoin sous Ubuntu 23.10 et suivants.
profil-bwrap:
	@cat correction/src/main/resources/bwrap.apparmor

# Refaire les notes et les pages de ce qui a été jugé : après un changement de bareme.ini ou d'ajustements.csv.
noter: $(CORRECTION)
	@$(CORRIGER) --noter $(if $(NOTES),--notes "$(NOTES)") $(if $(BAREME),--bareme "$(BAREME)") $(if $(SORTIE),--sortie "$(SORTIE)")

# Trente rendus différents : combien de temps, combien de mémoire.
mesure-corriger: $(CORRECTION)
	@JAVA="$(JAVA)" CORRIGER="$(CORRIGER)" outils/mesure-corriger.sh

# La page de la classe que donnent les rendus d'essai, telle que sa page la montre : Chromium la photographie.
image-classe: $(CORRECTION)
	@command -v chromium >/dev/null || { echo "Il faut Chromium : sudo apt-get install chromium" >&2; exit 1; }
	@$(JAVA) -jar $(CORRECTION) --sortie target/classe-image correction/src/test/resources/classe
	@chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1250,1860 \
	    --screenshot=images/classe.png "file://$(CURDIR)/target/classe-image/index.html" 2>/dev/null

aide:
	@echo "make                       construit, et dessine scenes/scene1.ini dans une fenêtre"
	@echo "make run SCENE=fichier     une autre scène ; VARIANTES=\"brume blinn\" ; OPTIONS=\"--reflets 2\" pour le programme"
	@echo "make test                  tous les tests de tous les modules"
	@echo "make comparer A=… B=…      compare deux images, ou une image et une scène"
	@echo "make squelette DOSSIER=…   écrit le projet à compléter que reçoivent les étudiants"
	@echo "make corrige DOSSIER=…     écrit le programme fini du cours ; VARIANTE=brume, antialias ou blinn pour une extension"
	@echo "make corriger RENDUS=…     juge et note les rendus d'une classe, ou un seul dossier ; NOTES=feuille.csv de Moodle"
	@echo "    … AJOUTER=1            ajoute ou remplace ces rendus, sans juger les autres"
	@echo "make noter                 refait les notes : bareme.ini ou ajustements.csv a changé ; NOTES=feuille.csv de Moodle"
	@echo "make propre                efface ce qui est construit"
	@echo "Options du programme : docs/options.md. Classe : docs/classe.md. Mesures, images, toutes les cibles : docs/construire.md"

propre: outils
	@$(MVN) -q -f ensemble.xml clean
