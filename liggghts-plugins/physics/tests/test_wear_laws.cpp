/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "physics/wear/wear_laws.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

using namespace grainjet::wear;

namespace {

const double DEGREE = HALF_PI / 90.0;

// A quartz grain of 110 um
const double MASS = 1.8468e-9, DIAMETER = 110e-6;

Impact hit(double speed, double degrees)
{
  return Impact{speed, degrees * DEGREE, MASS, DIAMETER};
}

std::vector<std::string> split(const std::string &line)
{
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::unique_ptr<WearLaw> law(const std::string &line)
{
  std::vector<std::string> words = split(line);
  const std::string name = words.front();
  words.erase(words.begin());
  return makeWearLaw(name, words);
}

// What() of the error that a line of coefficients ends in
std::string complaint(const std::string &line)
{
  try {
    law(line);
  } catch (const std::invalid_argument &error) {
    return error.what();
  }
  return "";
}

struct Value {
  const char *line;
  double speed;
  double volume[5];    // at 5, 15, 30, 60 and 90 degrees
};

// The formulas as printed, computed apart from this with 30 digits (mpmath)
const Value VALUES[] = {
  {"finnie k 1e-10", 50, {6.9651972977e-17, 1.3806589339e-16, 1.15425e-16, 3.8475e-17, 0}},
  {"finnie k 1e-10 ratio 5.4", 50, {7.6276552276e-17, 1.9648551607e-16, 2.7159392893e-16, 1.038825e-16, 0}},
  {"oka abrasive SiO2 hardness 1.8e9", 80,
    {2.8652830144e-17, 5.5846573269e-17, 6.9825590429e-17, 5.9224158294e-17, 4.9098096482e-17}},
  {"oka abrasive SiC hardness 0.36e9", 80,
    {8.0409051262e-17, 1.0846933782e-16, 9.3640398733e-17, 5.227511949e-17, 3.9593844347e-17}},
  {"oka abrasive glass hardness 1.2e9", 80,
    {7.4969649429e-20, 1.6279312529e-18, 8.524089535e-18, 2.3592807215e-17, 2.7056555966e-17}},
  {"dnv material steel", 60, {7.6752272555e-18, 1.5969450866e-17, 1.9666368062e-17, 1.6412883613e-17, 1.1931629528e-17}},
  {"dnv material SiC", 60, {5.1426432662e-19, 1.5427929798e-18, 3.0855859597e-18, 6.1711719194e-18, 9.2567578791e-18}},
  {"ecrc brinell 120 sharpness 0.53 density 7800", 45,
    {6.2482940837e-18, 1.3847406815e-17, 1.8781604946e-17, 2.036222229e-17, 1.5579214638e-17}}};

}

TEST(WearLaws, ReferenceValues)
{
  const double degrees[] = {5, 15, 30, 60, 90};
  for (const Value &v : VALUES)
    for (int i = 0; i < 5; i++)
      EXPECT_NEAR(law(v.line)->volume(hit(v.speed, degrees[i])), v.volume[i], 1e-9 * v.volume[2]) << v.line << ' ' << degrees[i];
}

// A grain of f_cg = 3 wears as 27 impacts of its particles. Archard goes by the grain's work alone
TEST(WearLaws, Grains)
{
  for (const Value &v : VALUES) {
    Impact grain = hit(v.speed, 40);
    const double one = law(v.line)->volume(grain);
    grain.particles = 27;
    EXPECT_NEAR(law(v.line)->volume(grain) / one, 27, 1e-12) << v.line;
  }
  Impact grain = hit(10, 20);
  grain.slidingWork = 2e-6;
  grain.particles = 27;
  EXPECT_NEAR(law("archard K 1e-3 hardness 2e9")->volume(grain), 1e-18, 1e-30);
}

/* What the sources say of their laws. Finnie: largest at tan 2a = 2/3 (16.8 degrees), M V^2/(8 p) times g with K = 2 and
   half of the particles cutting. Oka: g = 1 at 90 degrees. E/CRC: the polynomial is 1 at 90 degrees (its digits: 1e-4).
   DNV: ductile F is at most 1, which its digits give to 0.3 %, and 0.6 at 90 degrees. */
TEST(WearLaws, AsPublished)
{
  const auto finnie = law("finnie pressure 1e9");
  const double a = 0.5 * std::atan(2.0 / 3.0) / DEGREE, top = finnie->volume(hit(100, a));
  EXPECT_NEAR(top, MASS * 1e4 / 8e9 * (std::sqrt(13.0) - 3.0) / 2.0, 1e-12 * top);
  EXPECT_LT(finnie->volume(hit(100, a - 1)), top);
  EXPECT_LT(finnie->volume(hit(100, a + 1)), top);
  EXPECT_NEAR(finnie->volume(hit(100, 90)), 0, 1e-12 * top);

  for (const char *abrasive : {"SiO2", "SiC", "glass"}) {
    const Coefficients c("oka", Oka::coefficients(), {"abrasive", abrasive, "hardness", "1.8e9"});
    EXPECT_NEAR(Oka(c).angleFactor(HALF_PI), 1, 1e-12);
  }
  EXPECT_NEAR(Ecrc::angleFactor(HALF_PI), 1, 1e-4);

  const Dnv steel(Coefficients("dnv", Dnv::coefficients(), {"material", "steel"}));
  double most = 0;
  for (double degrees = 0; degrees <= 90; degrees += 0.1) most = std::fmax(most, steel.angleFactor(degrees * DEGREE));
  EXPECT_NEAR(most, 1, 0.003);
  EXPECT_NEAR(steel.angleFactor(HALF_PI), 0.6, 1e-12);
}

// The exponents of sand on steel of 1.8 GPa that manuals give rounded: 0.8, 1.3 (1.38 here), 2.35
TEST(WearLaws, PresetIsItsNumbers)
{
  const auto preset = law("oka abrasive SiO2 hardness 1.8e9");
  const auto numbers = law("oka hardness 1.8e9 E90 60.57321933 k2 2.3519506 k3 0.19 n1 0.77089726 n2 1.3811953 "
    "referenceSpeed 104 referenceDiameter 326e-6");
  for (double degrees : {5.0, 30.0, 90.0})
    EXPECT_NEAR(numbers->volume(hit(80, degrees)) / preset->volume(hit(80, degrees)), 1, 1e-7);
  EXPECT_NEAR(law("dnv K 2e-9 n 2.6 density 7800 curve ductile")->volume(hit(60, 30))
    / law("dnv material steel")->volume(hit(60, 30)), 1, 1e-12);
  EXPECT_NEAR(law("dnv material steel curve brittle density 3900")->volume(hit(60, 45))
    / law("dnv K 2e-9 n 2.6 density 7800 curve brittle")->volume(hit(60, 45)), 2, 1e-12);
}

TEST(WearLaws, Range)
{
  for (const Value &v : VALUES) {
    const auto one = law(v.line);
    EXPECT_EQ(one->volume(hit(0, 30)), 0) << v.line;
    EXPECT_EQ(one->volume(hit(50, 0)), 0) << v.line;
    EXPECT_GE(one->volume(hit(50, 90 + 1e-10)), 0) << v.line;
    for (double degrees : {-1.0, 91.0, 180.0, std::nan("")}) {
      try {
        one->volume(hit(50, degrees));
        ADD_FAILURE() << v.line << ' ' << degrees;
      } catch (const std::domain_error &error) {
        EXPECT_NE(std::string(error.what()).find("angle"), std::string::npos) << error.what();
      }
    }
    EXPECT_THROW(one->volume(hit(-1, 30)), std::domain_error);
  }
}

TEST(WearLaws, Errors)
{
  const char *cases[][3] = {
    {"oka abrasive SiO2", "'hardness' missing", "Pa"},
    {"oka abrasive sand hardness 1.8e9", "unknown", "SiO2, SiC, glass"},
    {"oka hardness 1.8e9", "needs an abrasive", "referenceDiameter"},
    {"oka hardness 1.8e9 E90 60 k2 2.3 k3 0.19 n1 0.8 n2 1.3 referenceSpeed 104", "'referenceDiameter' missing", ""},
    {"oka abrasive SiO2 hardness 1.8", "outside", "Pa"},          // given in GPa
    {"finnie", "either k", "pressure"},
    {"finnie k 1e-10 pressure 1e9", "either k", ""},
    {"finnie k 1e-10 psi 2", "'psi' goes with pressure", ""},
    {"finnie k -1", "above 0", "'-1'"},
    {"finnie k 1e-10x", "above 0", "'1e-10x'"},
    {"finnie k", "has no value", ""},
    {"finnie k 1e-10 k 1e-10", "twice", ""},
    {"finnie pressure 1e9 fraction 2", "outside", ""},
    {"finnie pressur 1e9", "unknown coefficient 'pressur'", "pressure (flow"},
    {"dnv material stel", "'material stel' is unknown", "steel"},
    {"dnv density 7800", "needs a material", ""},
    {"dnv K 2e-9 n 2.6 density 7800", "'curve' missing", ""},
    {"dnv material steel curve tough", "unknown", "ductile, brittle"},
    {"ecrc sharpness 1 density 7800", "'brinell' missing", ""},
    {"ecrc brinell 120 sharpness 1", "'density' missing", "kg/m3"},
    {"ecrc brinell 1.2e9 sharpness 1 density 7800", "outside", ""},
    {"ecrc brinell 120 sharpness 3 density 7800", "outside", ""},
    {"archard K 1e-3", "'hardness' missing", "Pa"},
    {"archard K 2 hardness 2e9", "outside", ""},
    {"tabor k 1", "unknown law of wear 'tabor'", "archard"}};
  for (const auto &c : cases) {
    const std::string said = complaint(c[0]);
    EXPECT_NE(said.find(c[1]), std::string::npos) << c[0] << ": " << said;
    EXPECT_NE(said.find(c[2]), std::string::npos) << c[0] << ": " << said;
  }
}

// Scripts put other keywords behind the coefficients
TEST(WearLaws, WhereCoefficientsEnd)
{
  const std::vector<std::string> words = split("wear dnv material steel n 2.5 file a.csv");
  EXPECT_EQ(coefficientWords("dnv", words, 2), 4u);
  EXPECT_EQ(coefficientWords("finnie", words, 2), 0u);
  EXPECT_EQ(coefficientWords("dnv", split("material"), 0), 1u);
  EXPECT_THROW(coefficientWords("tabor", words, 2), std::invalid_argument);
}

TEST(WearLaws, NoFloatingPointException)
{
  for (const Value &v : VALUES)
    for (double speed : {0.0, 1e-12, 1.0, 400.0})
      for (double degrees : {0.0, 1e-9, 45.0, 90.0}) {
        const auto one = law(v.line);
        std::feclearexcept(FE_ALL_EXCEPT);
        volatile double volume = one->volume(hit(speed, degrees));
        EXPECT_TRUE(std::isfinite(volume) && volume >= -1e-40) << v.line << ' ' << speed << ' ' << degrees;
        EXPECT_FALSE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW)) << v.line << ' ' << speed << ' ' << degrees;
      }
}
