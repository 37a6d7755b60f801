# Ce que partagent le Makefile de la racine, celui d'outils et ceux des variantes. Voir « make aide ».

# Une erreur pour le make des BSD (bmake), qui ne lirait pas la suite ; pour GNU make, une règle que rien n'emploie.
.error Ce projet demande GNU make : il s'appelle gmake, ou make

RACINE := $(patsubst %/,%,$(dir $(lastword $(MAKEFILE_LIST))))
MVN ?= mvn -B -ntp
JAVA ?= java

# La scène à montrer (celle qui a le nom de la variante, ou celle du cours), les options du programme, et les variantes à mettre ensemble.
SCENE ?= scenes/$(or $(basename $(notdir $(wildcard $(RACINE)/scenes/$(VARIANTE).ini))),scene1).ini
OPTIONS ?=
VARIANTES ?= $(VARIANTE)

# Sans UTF-8, Java montrerait « sph?re » et ne saurait ouvrir un fichier au nom accentué. La machine le sait : LANG peut nommer ce qu'elle n'a pas.
ifneq ($(shell locale charmap 2>/dev/null),UTF-8)
export LC_ALL := C.UTF-8
endif

BASE := $(RACINE)/target/lancer.jar
JARS := $(or $(foreach v,$(VARIANTES),$(RACINE)/$(v)/target/$(v).jar),$(BASE))
vide :=
CHEMIN := $(subst $(vide) $(vide),:,$(strip $(JARS)))
PROGRAMME := -cp $(CHEMIN) lancer.Main
# La machine virtuelle d'une image par processus : docs/vitesse-et-precision.md dit ce que ces options épargnent. Une fenêtre, qui dure, va plus vite
# sans elles. JAVA_OPTIONS les remplace toutes.
OPTIONS_IMAGE := $(if $(filter undefined,$(origin JAVA_OPTIONS)),-XX:+IgnoreUnrecognizedVMOptions -XX:+UseSerialGC -Xmn16m,$(JAVA_OPTIONS))
JAVA_IMAGE := $(JAVA) $(OPTIONS_IMAGE)
JAVA_FENETRE := $(JAVA) $(JAVA_OPTIONS)

.DEFAULT_GOAL := run
.PHONY: run outils toujours
# deux Maven ne peuvent écrire à la fois dans target, quoi que demande MAKEFLAGS
.NOTPARALLEL:

# Une fenêtre, ou à défaut d'écran une image : là où DISPLAY manque, ou nomme un écran qui ne répond pas (statut 1).
# L'image porte le nom de la variante dans le dossier de celle-ci, à la racine celui de la scène et des variantes mises ensemble.
run: $(JARS)
	@case "$(OPTIONS)" in \
	    *--image*|*--lineaire*|*--pixel*|*--comparer*|*--aide*|*--version*) $(JAVA_IMAGE) $(PROGRAMME) $(OPTIONS) "$(SCENE)"; exit;; \
	esac; \
	if [ -n "$$DISPLAY" ] || [ "$$(uname)" = Darwin ]; then \
	    $(JAVA_FENETRE) $(PROGRAMME) $(OPTIONS) "$(SCENE)"; statut=$$?; \
	    [ $$statut = 1 ] || exit $$statut; \
	fi; \
	nom="$(VARIANTE)"; \
	png="$$PWD/target/$${nom:-$$(basename "$(SCENE)" .ini)$(subst $(vide) $(vide),,$(VARIANTES:%=-%))}.png"; \
	$(JAVA_IMAGE) $(PROGRAMME) $(OPTIONS) --image "$$png" "$(SCENE)" && echo "Pas d'écran ici : l'image est dans $$png"

# Dans le dossier d'une variante, les tests de son paquet ; à la racine, ceux de tout.
ifeq ($(origin VARIANTE),file)
.PHONY: test
test: outils
	$(MVN) -f $(RACINE)/ensemble.xml -pl :$(VARIANTE) -am -Dtest='lancer/$(VARIANTE)/*' \
	    -Dsurefire.failIfNoSpecifiedTests=false package
endif

# Ce qui dit où trouver ce paquet de Debian.
installer = $(if $(shell command -v apt-get), : sudo apt-get install $(1), ; docs/construire.md dit où le trouver)

outils:
	@[ -z "$$JAVA_HOME" ] || [ -x "$$JAVA_HOME/bin/javac" ] || { echo "JAVA_HOME=$$JAVA_HOME n'est pas le dossier d'un JDK :" \
	    "unset JAVA_HOME, ou lui en donner un" >&2; exit 1; }
	@command -v javac >/dev/null || { echo "Il faut un JDK, 11 ou plus récent$(call installer,default-jdk)" >&2; exit 1; }
	@command -v $(firstword $(MVN)) >/dev/null || { echo "Il faut Maven$(call installer,maven)" >&2; exit 1; }
	@mkdir -p $(RACINE)/target 2>/dev/null && [ -w $(RACINE)/target ] || { echo "Tout se construit dans $$(cd $(RACINE) && pwd)/target," \
	    "où rien ne peut s'écrire : copier le projet dans un dossier à soi, et y lancer make" >&2; exit 1; }

# Maven refait un jar là où quelque chose est plus récent que lui : un pom, une source, ou le dossier d'une source ajoutée ou effacée.
# Il travaille sans rien dire : la première fois, une demi-minute.
SOURCES = $(RACINE)/*.xml $(RACINE)/*/pom.xml $(RACINE)/src/main $(if $(filter lancer,$(notdir $*)),,$(@D)/../src) \
    $(if $(filter mesures correction,$(notdir $*)),$(RACINE)/*/src/main $(RACINE)/src/test/java/lancer/Tests.java)

%.jar: toujours | outils
	@if [ ! -e $@ ] || [ -n "$$(find $(SOURCES) -newer $@ | head -n 1)" ]; then \
	    touch $(RACINE)/target/maintenant; avenir=$$(find $(SOURCES) -newer $(RACINE)/target/maintenant | head -n 1); \
	    [ -z "$$avenir" ] || echo "$$avenir est daté de l'avenir, donc reconstruit à chaque fois : touch $$avenir"; \
	    echo "Construction de $@ ; la toute première fois, Maven télécharge une trentaine de Mo"; \
	    $(MVN) -q -f $(RACINE)/ensemble.xml -pl :$(notdir $*) -am -DskipTests package && touch $@; \
	fi

toujours:
