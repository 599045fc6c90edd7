#include "io/status_code.hpp"

#include <gtest/gtest.h>

namespace stemwise {
namespace {

StemStatus said(std::string_view code) { return status_from_code(code, false); }

TEST(StatusCode, MissingIsNeverDead) {
  for (const char* code : {"missing", "Missing", "not found", "vermisst", "nicht gefunden", "no encontrado", "non trouvé", "prior"}) EXPECT_EQ(said(code), StemStatus::missing) << code;
}

TEST(StatusCode, FelledTreesAreRemoved) {
  for (const char* code : {"cut", "Removed", "stump", "harvested", "entnommen", "gefällt", "GEFÄLLT", "gefaellt", "abattu", "coupé", "talado", "tocón", "cut stump", "logged", "tagliato"})
    EXPECT_EQ(said(code), StemStatus::removed) << code;
}

TEST(StatusCode, DeadWordsOfFourLanguagesAreDead) {
  for (const char* code : {"dead", "D", "abgestorben", "fallen", "tot", "standing dead", "dead standing", "dead, fallen", "snag", "mort", "mort sur pied", "muerto", "muerto en pie", "morto", "0", "false", "gone", "stehend tot"})
    EXPECT_EQ(said(code), StemStatus::dead) << code;
}

TEST(StatusCode, LivingWordsAreAlive) {
  for (const char* code : {"A", "alive", "lebend", "vivant", "vivo", "1", "true", "alive, broken", "live"}) EXPECT_EQ(said(code), StemStatus::alive) << code;
}

TEST(StatusCode, WhatIsSaidOfAPartOrDeniedOrContradictsItselfIsUnknown) {
  for (const char* code : {"dead top", "not dead", "alive or dead", "half dead", "crown dead", "xyz", "M", "7", ""}) EXPECT_EQ(said(code), StemStatus::unknown) << code;
}

TEST(StatusCode, FiaCountsFromOne) {
  EXPECT_EQ(status_from_code("2", true), StemStatus::dead);
  EXPECT_EQ(status_from_code("2", false), StemStatus::unknown);
}

}  // namespace
}  // namespace stemwise
