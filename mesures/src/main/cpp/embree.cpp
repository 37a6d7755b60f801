// Un pair en C++ : les mêmes images, les rayons étant lancés un par un dans les sphères d'Embree 3 (libembree-dev), qui compte en float.
// Le contact et la normale sont recalculés en double, de la sphère touchée.
//   embree SCENE.ini LARGEUR HAUTEUR FILS IMAGE.ppm        statut 1 s'il ne peut lire la scène ou écrire l'image
#include <embree3/rtcore.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

struct V {
    double x, y, z;
    V operator+(V b) const { return {x + b.x, y + b.y, z + b.z}; }
    V operator-(V b) const { return {x - b.x, y - b.y, z - b.z}; }
    V operator*(double k) const { return {k * x, k * y, k * z}; }
    V operator*(V b) const { return {x * b.x, y * b.y, z * b.z}; }
    double dot(V b) const { return x * b.x + y * b.y + z * b.z; }
    V unite() const { return *this * (1 / std::sqrt(dot(*this))); }
};

struct Sphere { V centre{}, kd{}, ks{}; double rayon = 0, ns = 1; };
struct Lampe { V position{}, couleur{}; };

static std::vector<Sphere> spheres;
static std::vector<Lampe> lampes;
static RTCScene scene;

static const int REFLETS = 5;
static const double SEUIL = 1.0 / 1024, FOCALE = 1 / std::tan(std::acos(-1.0) / 12);

// Ce que « make mesures » engendre : une clé par ligne, sans blanc autour du signe égal.
static bool lire(const char *nom) {
    std::ifstream f(nom);
    std::string ligne;
    bool sphere = false;
    while (std::getline(f, ligne)) {
        size_t egal = ligne.find('=');
        if (ligne.compare(0, 7, "[Sphere") == 0) {
            sphere = true;
            spheres.emplace_back();
        } else if (ligne.compare(0, 6, "[Lampe") == 0) {
            sphere = false;
            lampes.emplace_back();
        } else if (egal != std::string::npos && ligne[0] != ';' && ligne[0] != '#') {
            std::string cle = ligne.substr(0, egal);
            V v{};
            char *suite = &ligne[egal + 1];
            for (double *d : {&v.x, &v.y, &v.z}) *d = std::strtod(suite, &suite);
            if (!sphere) (cle == "position" ? lampes.back().position : lampes.back().couleur) = v;
            else if (cle == "rayon") spheres.back().rayon = v.x;
            else if (cle == "ns") spheres.back().ns = v.x;
            else (cle == "centre" ? spheres.back().centre : cle == "Kd" ? spheres.back().kd : spheres.back().ks) = v;
        }
    }
    return !spheres.empty();
}

static RTCRay rayon(V p, V v, double max) {
    RTCRay r{};
    r.org_x = (float) p.x; r.org_y = (float) p.y; r.org_z = (float) p.z;
    r.dir_x = (float) v.x; r.dir_y = (float) v.y; r.dir_z = (float) v.z;
    r.tfar = (float) max;
    r.mask = -1u;
    return r;
}

static V voir(V p, V v, V depart, int reflets, V produit) {
    RTCIntersectContext contexte;
    rtcInitIntersectContext(&contexte);
    RTCRayHit touche{};
    touche.ray = rayon(depart, v, INFINITY);
    touche.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &contexte, &touche);
    if (touche.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return v.y > 0 ? V{0.7 * (1 - v.y), 0.7 * (1 - v.y), 1} : V{0.5, 0.4 + 0.2 * v.y, 0.1};
    const Sphere &s = spheres[touche.hit.primID];
    V f = s.centre - p;
    double b = f.dot(v);
    V l = f - v * b;
    V c = p + v * (b - std::sqrt(std::max(0.0, s.rayon * s.rayon - l.dot(l))));
    V n = (c - s.centre).unite();
    V r = (v - n * (2 * v.dot(n))).unite();
    // les rayons partent un peu au-dessus de la surface : en float, elle se toucherait elle-même
    V dessus = c + n * std::min(2e-6 * (std::fabs(c.x) + std::fabs(c.y) + std::fabs(c.z)), 0.01 * s.rayon);
    V somme{};
    for (const Lampe &lampe : lampes) {
        V vers = lampe.position - c;
        double d = std::sqrt(vers.dot(vers));
        V u = vers * (1 / d);
        if (n.dot(u) <= 0) continue;
        RTCRay ombre = rayon(dessus, u, d);
        rtcOccluded1(scene, &contexte, &ombre);
        if (ombre.tfar < 0) continue;
        somme = somme + lampe.couleur * (s.kd * n.dot(u) + s.ks * std::pow(std::max(0.0, r.dot(u)), s.ns));
    }
    produit = produit * s.ks;
    if (reflets > 0 && std::max({produit.x, produit.y, produit.z}) >= SEUIL) somme = somme + s.ks * voir(c, r, dessus, reflets - 1, produit);
    return somme;
}

int main(int n, char **args) {
    if (n < 6 || !lire(args[1])) return 1;
    int largeur = std::atoi(args[2]), hauteur = std::atoi(args[3]), fils = std::atoi(args[4]);
    RTCDevice machine = rtcNewDevice(("threads=" + std::to_string(fils)).c_str());
    scene = rtcNewScene(machine);
    RTCGeometry forme = rtcNewGeometry(machine, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    float *quatre = (float *) rtcSetNewGeometryBuffer(forme, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 16, spheres.size());
    for (const Sphere &s : spheres)
        for (double d : {s.centre.x, s.centre.y, s.centre.z, s.rayon}) *quatre++ = (float) d;
    rtcCommitGeometry(forme);
    rtcAttachGeometry(scene, forme);
    rtcCommitScene(scene);
    std::vector<unsigned char> image(3 * (size_t) largeur * hauteur);
    std::atomic<int> ligne(0);
    std::vector<std::thread> equipe;
    for (int k = 0; k < fils; k++) equipe.emplace_back([&] {
        for (int j = ligne++; j < hauteur; j = ligne++)
            for (int i = 0; i < largeur; i++) {
                V p{(i + 0.5 - largeur / 2.0) * 2 / largeur, (hauteur / 2.0 - j - 0.5) * 2 / largeur, 0};
                V c = voir(p, V{p.x, p.y, FOCALE}.unite(), p, REFLETS, {1, 1, 1});
                double composantes[] = {c.x, c.y, c.z};
                for (int k = 0; k < 3; k++)
                    image[3 * ((size_t) j * largeur + i) + k] = (unsigned char) (255 * std::min(1.0, std::max(0.0, composantes[k])) + 0.5);
            }
    });
    for (std::thread &fil : equipe) fil.join();
    std::FILE *ppm = std::fopen(args[5], "wb");
    return ppm == nullptr || std::fprintf(ppm, "P6\n%d %d\n255\n", largeur, hauteur) < 0
            || std::fwrite(image.data(), 1, image.size(), ppm) < image.size() || std::fclose(ppm) != 0;
}
