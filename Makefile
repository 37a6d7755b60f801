include commun.mk

VARIANTES_TOUTES := brume antialias blinn
N ?= 1000000
# L'écran des tests de la fenêtre, qui n'est pas celui de l'utilisateur ; rien là où Xvfb manque.
ifneq ($(and $(shell command -v xvfb-run),$(shell command -v Xvfb),$(shell command -v xauth)),)
XVFB := xvfb-run -a -s "-screen 0 1280x800x24"
endif
# Vide, ces tests sont laissés de côté ; FENETRES=exigees les fait là où Xvfb manque aussi, sur l'écran de l'utilisateur.
FENETRES ?= $(if $(XVFB),exigees)

.PHONY: test application javadoc scene-geante mesures juge mesure-auto mesure-recherche comparer squelette corrige corriger profil-bwrap noter aide propre

# Les tests de tous les modules, par groupes qui ne s'attendent pas. Maven dit où il en est, module par module et classe par classe, et va
# au bout même si des tests échouent : après un changement voulu, il les nomme tous.
test: outils
	@echo "Tous les tests : quatre à six minutes sur deux cœurs"
	$(XVFB) $(MVN) -T 4 -fae -Pgroupes $(if $(FENETRES),-Dfenetre.exigee=true) package
	@$(if $(FENETRES),,echo "Les tests qui ouvrent une fenêtre sont laissés de côté. Pour les avoir : sudo apt-get install xvfb xauth")

# Un programme qui se lance sans JDK : sa machine virtuelle, ses options et, avec VARIANTES="brume blinn", les variantes. Celle d'une image
# par processus, dont l'archive de classes est refaite : sans elle, Java démarre deux fois plus lentement.
APPLICATION := target/lancer
application: $(JARS)
	@command -v jpackage >/dev/null || { echo "Il faut jpackage, que contient un JDK 14 ou plus récent : sudo apt-get install default-jdk" >&2; exit 1; }
	@rm -rf $(APPLICATION) target/application && mkdir -p target/application && cp $(JARS) target/application
	@jpackage --type app-image --name $(notdir $(APPLICATION)) --dest $(dir $(APPLICATION)) --input target/application \
	    --main-jar $(notdir $(firstword $(JARS))) --main-class lancer.Main --add-modules java.desktop,java.logging,java.prefs,jdk.localedata \
	    --jlink-options "--strip-debug --no-man-pages --no-header-files --include-locales=fr" \
	    $(OPTIONS_IMAGE:%=--java-options %)
	@$(APPLICATION)/lib/runtime/bin/java -Xshare:dump >/dev/null && rm -r $(APPLICATION)/lib/runtime/bin
	@mv $(APPLICATION)/lib/app/lancer.cfg $(APPLICATION)/lib/app/lanceur.cfg && mv $(APPLICATION)/bin/lancer $(APPLICATION)/bin/lanceur
	@cp outils/lancer.sh $(APPLICATION)/bin/lancer && chmod +x $(APPLICATION)/bin/lancer
	@echo "$(APPLICATION)/bin/lancer : le programme et sa machine virtuelle, $$(du -sh $(APPLICATION) | cut -f1)"

# La Javadoc de chaque module, dans son dossier target/reports/apidocs.
javadoc: outils
	@$(MVN) -q -DskipTests package javadoc:javadoc

# Une scène de N boules, ou une scène difficile (N=poussiere, etoile…) : make run SCENE=target/geante.ini
scene-geante: mesures/target/mesures.jar
	@mkdir -p target
	@$(JAVA) -cp mesures/target/mesures.jar lancer.mesures.scenes.Foule $(N) > target/geante.tmp && mv target/geante.tmp target/geante.ini
	@echo "target/geante.ini : $(N), $$(wc -c < target/geante.ini) octets"

# Les courbes de vitesse et de précision, de mesures faites maintenant. Interrompue ou refusée, elle ne change rien à mesures/resultats.
# MESURES=--dessiner refait les courbes des mesures de mesures/resultats, sans mesurer ; MESURES=--comptes mesure tout ce qui ne se
# chronomètre pas, si chargée que soit la machine, et MESURES=--temps le reste ; MESURES=--stabilite ne mesure que la stabilité.
# MESURES=--verifier échoue si quelques comptes ne sont plus ceux d'aujourd'hui.
mesures: mesures/target/mesures.jar $(BASE) $(foreach v,$(VARIANTES_TOUTES),$(v)/target/$(v).jar) | mesures/target/embree
	@$(JAVA) -cp mesures/target/mesures.jar lancer.mesures.vitesse.Vitesse $(MESURES)

# Un pair en C++, pour les mesures.
mesures/target/embree: mesures/src/main/cpp/embree.cpp
	@g++ -O3 -march=native -pthread -o $@ $< -lembree3 2>/dev/null || echo "Sans Embree : sudo apt-get install g++ libembree-dev"

# Les mêmes scènes dessinées par POV-Ray ; JUGE="--reflets 3 target/geante.ini" pour d'autres.
juge: mesures/target/mesures.jar
	@$(JAVA) -cp mesures/target/mesures.jar lancer.mesures.juge.Juge $(JUGE)

# --auto tient-il parole, et à quel prix ? Contre l'échelle dessinée.
mesure-auto: mesures/target/mesures.jar
	@$(JAVA) -cp mesures/target/mesures.jar lancer.mesures.vitesse.MesureAuto mesures/resultats/auto.csv $(AUTO)
	@$(JAVA) -cp mesures/target/mesures.jar lancer.mesures.vitesse.Vitesse --dessiner

# Les boucles ou les structures, selon les objets et les rayons à venir : la table que cite lancer.rapide.Preparation.
mesure-recherche: mesures/target/mesures.jar
	@$(JAVA) -cp mesures/target/mesures.jar lancer.mesures.vitesse.MesureRecherche mesures/resultats/recherche.csv

CORRECTION := correction/target/correction.jar
# il ne dure pas : compiler à fond coûterait de la mémoire sans rien gagner (outils/mesure-corriger.sh)
CORRIGER = $(JAVA) -XX:TieredStopAtLevel=1 -XX:+UseSerialGC -jar $(CORRECTION)

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
# UN=dossier : un seul rendu. Ces rendus s'ajoutent à ceux qui ont été jugés, ou remplacent les leurs ; NEUF=1 les met d'abord de côté.
corriger: $(CORRECTION)
	@test -n "$(RENDUS)$(UN)" || { echo "Quels rendus ? make corriger RENDUS=classe.zip (ou UN=rendu) [NOTES=feuille.csv] [NEUF=1]" >&2; exit 2; }
	@$(CORRIGER) $(if $(NOTES),--notes "$(NOTES)") $(if $(BAREME),--bareme "$(BAREME)") $(if $(SORTIE),--sortie "$(SORTIE)") \
	    $(if $(filter-out 0 non,$(NEUF)),--neuf) $(if $(filter-out 0 non,$(SANS_CONFINEMENT)),--sans-confinement) \
	    $(if $(UN),--un "$(UN)","$(RENDUS)")

# Le profil AppArmor dont bwrap a besoin sous Ubuntu 23.10 et suivants.
profil-bwrap:
	@cat correction/src/main/resources/bwrap.apparmor

# Refaire les notes et les pages de ce qui a été jugé : après un changement de bareme.ini ou d'ajustements.csv.
noter: $(CORRECTION)
	@$(CORRIGER) --noter $(if $(NOTES),--notes "$(NOTES)") $(if $(BAREME),--bareme "$(BAREME)") $(if $(SORTIE),--sortie "$(SORTIE)")

aide:
	@echo "make                       construit, et dessine scenes/scene1.ini dans une fenêtre"
	@echo "make run SCENE=fichier     une autre scène ; VARIANTES=\"brume blinn\" ; OPTIONS=\"--reflets 2\" pour le programme"
	@echo "make test                  tous les tests de tous les modules"
	@echo "make comparer A=… B=…      compare deux images, ou une image et une scène"
	@echo "make squelette DOSSIER=…   écrit le projet à compléter que reçoivent les étudiants"
	@echo "make corrige DOSSIER=…     écrit le programme fini du cours ; VARIANTE=brume, antialias ou blinn pour une extension"
	@echo "make corriger RENDUS=…     juge et note une classe, dossier ou archive : une entrée, une ligne ; NOTES=feuille.csv de Moodle"
	@echo "make corriger UN=…         un seul rendu ; NEUF=1, avec RENDUS ou UN, met de côté ce qui a été jugé avant"
	@echo "make noter                 refait les notes : bareme.ini ou ajustements.csv a changé ; NOTES=feuille.csv de Moodle"
	@echo "make propre                efface ce qui est construit"
	@echo "Options du programme : docs/options.md. Classe : docs/classe.md. Mesures : mesures/README.md. Sans make : docs/construire.md"

propre: outils
	@$(MVN) -q clean
