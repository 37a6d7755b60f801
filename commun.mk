# Ce que partagent le Makefile de la racine et ceux des variantes. Voir « make aide ».

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
JARS := $(if $(strip $(VARIANTES)),$(foreach v,$(VARIANTES),$(RACINE)/$(v)/target/$(v).jar),$(BASE))
vide :=
CHEMIN := $(subst $(vide) $(vide),:,$(strip $(JARS)))
PROGRAMME := -cp $(CHEMIN) lancer.Main
# La machine virtuelle d'une image par processus : docs/performance.md dit ce que ces options épargnent. Une fenêtre, qui dure, va plus vite
# sans elles. JAVA_OPTIONS les remplace toutes.
OPTIONS_IMAGE := $(if $(filter undefined,$(origin JAVA_OPTIONS)),-XX:+IgnoreUnrecognizedVMOptions -XX:+UseSerialGC -Xmn16m,$(JAVA_OPTIONS))
JAVA_IMAGE := $(JAVA) $(OPTIONS_IMAGE)
JAVA_FENETRE := $(JAVA) $(JAVA_OPTIONS)
POMS := $(RACINE)/ensemble.xml $(RACINE)/pom.xml
# Les sources d'un dossier, et leur liste : d'un fichier effacé, elle garde la trace jusqu'à ce que tout soit construit de nouveau.
sources = $(1)/target/sources.txt $(shell find $(1)/src/main -type f 2>/dev/null)

.DEFAULT_GOAL := run
.PHONY: run outils toujours

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
	png="$(CURDIR)/target/$${nom:-$$(basename "$(SCENE)" .ini)$(subst $(vide) $(vide),,$(VARIANTES:%=-%))}.png"; \
	$(JAVA_IMAGE) $(PROGRAMME) $(OPTIONS) --image "$$png" "$(SCENE)" && echo "Pas d'écran ici : l'image est dans $$png"

# Dans le dossier d'une variante, les tests de son paquet ; à la racine, ceux de tout.
ifeq ($(origin VARIANTE),file)
.PHONY: test
test: outils
	$(MVN) -f $(RACINE)/ensemble.xml -pl :$(VARIANTE) -am -Dtest='lancer/$(VARIANTE)/*' \
	    -Dsurefire.failIfNoSpecifiedTests=false verify
endif

outils:
	@command -v javac >/dev/null || { echo "Il faut un JDK, 11 ou plus récent : sudo apt-get install default-jdk" >&2; exit 1; }
	@command -v $(firstword $(MVN)) >/dev/null || { echo "Il faut Maven : sudo apt-get install maven" >&2; exit 1; }
	@mkdir -p $(RACINE)/target 2>/dev/null && [ -w $(RACINE)/target ] || { echo "Tout se construit dans $$(cd $(RACINE) && pwd)/target," \
	    "où rien ne peut s'écrire : copier le projet dans un dossier à soi, et y lancer make" >&2; exit 1; }

# Quand une source ou une ressource n'est plus là, tout ce que Maven en avait fait s'en va : il ne l'ôterait pas de lui-même.
LISTES := $(RACINE)/target/sources.txt \
	$(foreach m,$(sort $(VARIANTES) brume antialias blinn mesures correction),$(RACINE)/$(m)/target/sources.txt)
$(LISTES): toujours | outils
	@mkdir -p $(@D) && cd $(@D) && find ../src/main -type f 2>/dev/null | LC_ALL=C sort > sources.neuves; \
	if [ -e sources.txt ] && [ -n "$$(LC_ALL=C comm -23 sources.txt sources.neuves)" ]; then rm -rf classes; fi; \
	if cmp -s sources.txt sources.neuves; then rm sources.neuves; else mv sources.neuves sources.txt; fi

toujours:

# Maven travaille sans rien dire : la première fois, une demi-minute.
DIRE = @echo "Construction de $@$(if $(wildcard $(HOME)/.m2/repository/org/ini4j),, : Maven télécharge d'abord une trentaine de Mo)"

$(BASE): $(POMS) $(call sources,$(RACINE)) | outils
	$(DIRE)
	@$(MVN) -q -f $(RACINE)/ensemble.xml -pl :lancer -DskipTests package
	@touch $@

define jar_de_variante
$(RACINE)/$(1)/target/$(1).jar: $(POMS) $(RACINE)/$(1)/pom.xml $(call sources,$(RACINE)) $(call sources,$(RACINE)/$(1)) | outils
	$$(DIRE)
	@$(MVN) -q -f $(RACINE)/ensemble.xml -pl :$(1) -am -DskipTests package
	@touch $$@
endef
$(foreach v,$(sort $(VARIANTES) brume antialias blinn),$(eval $(call jar_de_variante,$(v))))
