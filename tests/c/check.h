/* What the tests of the C interface share. */
#ifndef RACEWAY_TESTS_C_CHECK_H
#define RACEWAY_TESTS_C_CHECK_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "c/raceway.h"

static int failures = 0;

#define CHECK(claim)                                                      \
  do {                                                                    \
    if (!(claim)) {                                                       \
      ++failures;                                                         \
      fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #claim); \
    }                                                                     \
  } while (0)

#define CHECK_TEXT(got, wanted)                                                             \
  do {                                                                                      \
    const char* got_ = (got);                                                               \
    const char* wanted_ = (wanted);                                                         \
    if (strcmp(got_, wanted_) != 0) {                                                       \
      ++failures;                                                                           \
      fprintf(stderr, "%s:%d: \"%s\"\n  where \"%s\" is right\n", __FILE__, __LINE__, got_, \
              wanted_);                                                                     \
    }                                                                                       \
  } while (0)

/* Ends the test: what follows needs this. */
#define REQUIRE(claim)               \
  do {                               \
    int before_ = failures;          \
    CHECK(claim);                    \
    if (failures > before_) exit(1); \
  } while (0)

static const char rig_text[] =
    "[bearing]\nname = \"7014\"\nball_count = 20\nball_diameter_mm = 11.906\n"
    "pitch_diameter_mm = 90.0\ncontact_angle_deg = 25.0\ninner_conformity = 0.52\n"
    "outer_conformity = 0.52\nstatic_load_rating_N = 43000\n"
    "[lubricant]\nviscosity_40C_mm2_s = 22.0\nviscosity_100C_mm2_s = 4.8\n"
    "[friction]\nlaw = \"palmgren\"\nf0 = 1.5\nz = 0.001\ny = 0.33\n"
    "[rig]\nbearings = 2\naxial_load_N = 300\n"
    "[[effect]]\nid = \"spin-friction\"\n"
    "[[effect]]\nid = \"torque-offset\"\ntorque_Nmm = 7\n";

static void write_file(const char* path, const char* text) {
  FILE* file = fopen(path, "w");
  if (file == NULL || fputs(text, file) < 0 || fclose(file) != 0) {
    fprintf(stderr, "%s cannot be written\n", path);
    exit(1);
  }
}

static raceway_model* model_of(const char* text) {
  char message[2000];
  raceway_model* model = raceway_create(text, "my.toml", message, sizeof message);
  if (model == NULL) {
    fprintf(stderr, "%s\n", message);
    exit(1);
  }
  return model;
}

#endif
