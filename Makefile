include commun.mk

N ?= 1000000
XVFB := xvfb-run -a -s "-screen 0 1280x800x24"

.PHONY: test images scene-geante aide propre

# Tout, tous modules ; les fenêtres s'ouvrent sur un écran à elles, pas sur celui de l'utilisateur.
test: outils
	@command -v xvfb-run >/dev/null && command -v xauth >/dev/null || \
	    { echo "Les tests de la fenêtre ont besoin de Xvfb : sudo apt-get install xvfb xauth" >&2; exit 1; }
	$(XVFB) $(MVN) -f ensemble.xml -Dfenetre.exigee=true verify

mesures/target/mesures.jar: $(POMS) mesures/pom.xml $(call sources,.) $(call sources,mesures) | outils
	@echo "Construction de $@"
	@$(MVN) -q -f ensemble.xml -pl :mesures -am -DskipTests package
	@touch $@

# Une scène de N boules, pour voir : make run SCENE=target/geante.ini
scene-geante: mesures/target/mesures.jar
	@mkdir -p target
	@$(JAVA) -cp mesures/target/mesures.jar lancer.mesures.Generateur foule $(N) > target/geante.ini
	@echo "target/geante.ini : $(N) boules, $$(wc -c < target/geante.ini) octets"

aide:
	@echo "make                       construit, et dessine scenes/scene1.ini dans une fenêtre"
	@echo "make run SCENE=fichier     une autre scène ; OPTIONS=\"--reflets 2\" pour le programme"
	@echo "make run VARIANTES=\"brume blinn\"   avec des variantes : brume, antialias, blinn"
	@echo "make test                  tous les tests de tous les modules"
	@echo "make images                refait les images du README"
	@echo "make scene-geante N=1000000   écrit une scène de N boules, target/geante.ini"
	@echo "make propre                efface ce qui est construit"

propre: outils
	@$(MVN) -q -f ensemble.xml clean
