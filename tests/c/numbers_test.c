/* The numbers of the C interface are those of the command. */
#include <math.h>

#include "tests/c/check.h"

static const char* program;
static const char* root;

enum { longest = 1 << 20 };

/* stdout of the command; to be freed. */
static char* printed(const char* arguments) {
  char command[3000];
  snprintf(command, sizeof command, "'%s' %s --quiet 2>/dev/null >command.out", program, arguments);
  (void)!system(command);
  FILE* file = fopen("command.out", "r");
  char* text = malloc(longest);
  REQUIRE(file != NULL && text != NULL);
  text[fread(text, 1, longest - 1, file)] = '\0';
  fclose(file);
  return text;
}

/* The next cell of a CSV, ended in its place. */
static char* cell(char** rest) {
  char* begin = *rest;
  char* end = begin + strcspn(begin, ",\n");
  *rest = *end == '\0' ? end : end + 1;
  *end = '\0';
  return begin;
}

static char* identifier(const char* name, char* out) {
  size_t i = 0;
  for (; name[i] != '\0'; ++i) out[i] = name[i] == '-' ? '_' : name[i];
  out[i] = '\0';
  return out;
}

/* The column of a name in a plain table, -1 where the table has no such column. */
static int column_of(const raceway_model* model, const char* head) {
  char name[200];
  for (size_t c = 0; c < raceway_column_count(model); ++c)
    if (strcmp(identifier(raceway_column_name(model, c), name), head) == 0) return (int)c;
  return -1;
}

static void check_cell(double value, const char* shown) {
  char text[50];
  if (isnan(value))
    strcpy(text, "NaN");
  else
    snprintf(text, sizeof text, "%.12g", value);
  CHECK_TEXT(text, shown);
}

/* Every cell of `raceway table --format plain`, and every status, digit by digit. */
static void a_table_is_that_of_the_command(const char* path, int shaft) {
  const double speed[] = {0, 2000, 9000, 20000}, axial[] = {0, 5, 300}, radial[] = {0, 40},
               temperature[] = {30, 70};
  const size_t radials = shaft ? 0 : 2, points = shaft ? 24 : 48;
  char message[2000], arguments[2000];
  raceway_model* model = raceway_create_from_file(path, message, sizeof message);
  REQUIRE(model != NULL);
  double* values = malloc(points * raceway_column_count(model) * sizeof *values);
  int status[48];
  const int result = raceway_table(model, speed, 4, axial, 3, radial, radials, temperature, 2, NULL,
                                   0, values, status, message, sizeof message);
  snprintf(arguments, sizeof arguments,
           "table '%s' --speed 0,2000,9000,20000 --axial-load 0,5,300 %s --temperature 30,70 "
           "-o - --format plain",
           path, shaft ? "" : "--radial-load 0,40");
  char* text = printed(arguments);
  char* rest = text;
  int columns[60], count = 0, converged = 1;
  for (;; ++count) {
    const int last = rest[strcspn(rest, ",\n")] == '\n';
    REQUIRE(count < 60);
    columns[count] = column_of(model, cell(&rest));
    CHECK(count < 4 || last || columns[count] >= 0);
    if (last) break;
  }
  ++count;
  CHECK(columns[4] == 0); /* friction_torque_Nmm, behind four inputs */
  for (size_t i = 0; i < points; ++i) {
    for (int c = 0; c < count; ++c) {
      const char* shown = cell(&rest);
      if (c == count - 1)
        CHECK_TEXT(shown, raceway_status_name(status[i]));
      else if (c >= 4)
        check_cell(values[(size_t)columns[c] * points + i], shown);
    }
    converged = converged && status[i] == RACEWAY_STATUS_CONVERGED;
  }
  CHECK(*rest == '\0');
  CHECK(result == (converged ? RACEWAY_DONE : RACEWAY_NOT_CONVERGED));
  free(text);
  free(values);
  raceway_free(model);
}

/* The number behind a key of a JSON document, the first of that name. */
static double number_of(const char* json, const char* key) {
  char quoted[200];
  snprintf(quoted, sizeof quoted, "\"%s\": ", key);
  const char* found = strstr(json, quoted);
  CHECK(found != NULL);
  return found ? strtod(found + strlen(quoted), NULL) : NAN;
}

/* A single state and many are solved by two solvers, which both end below 1e-11 of the load. */
static int same(double a, double b) { return fabs(a - b) <= 1e-9 * fabs(b); }

static void states_are_those_of_solve(const char* path, const char* flags, double axial,
                                      const char* const* names, size_t count) {
  char message[2000], arguments[2000];
  raceway_model* model = raceway_create_from_file(path, message, sizeof message);
  REQUIRE(model != NULL);
  const double speed[] = {5000, 8000}, temperature = 55;
  const int strides[] = {1, 0, -1, 0};
  double values[20];
  int wanted[10];
  for (size_t c = 0; c < count; ++c) wanted[c] = raceway_column_index(model, names[c]);
  const int result = raceway_solve(model, 2, speed, &axial, NULL, &temperature, strides, wanted,
                                   count, values, NULL, message, sizeof message);
  CHECK(result == RACEWAY_DONE);
  CHECK_TEXT(message, "");
  for (size_t i = 0; i < 2; ++i) {
    snprintf(arguments, sizeof arguments, "solve '%s' --speed %g %s --temperature 55 --json", path,
             speed[i], flags);
    char* json = printed(arguments);
    for (size_t c = 0; c < count; ++c) {
      const double told = number_of(json, names[c]);
      if (!same(values[c * 2 + i], told))
        fprintf(stderr, "%s: %.17g, not %.17g\n", names[c], values[c * 2 + i], told);
      CHECK(same(values[c * 2 + i], told));
    }
    free(json);
  }
  raceway_free(model);
}

/* A record made of readings is one that the command predicts without error. */
static void readings_are_those_that_compare_predicts(void) {
  enum { rows = 6 };
  const double speed[rows] = {1000, 2000, 4000, 1000, 8000, 6000},
               axial[rows] = {100, 500, 300, 900, 300, 100},
               temperature[rows] = {30, 40, 45, 50, 55, 60};
  double readings[rows], torque[rows];
  char message[2000], csv[2000] = "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n";
  raceway_model* model = model_of(rig_text);
  const int strides[] = {1, 1, -1, 1}, column = 0;
  CHECK(raceway_predict(model, rows, speed, axial, NULL, temperature, strides, readings, NULL,
                        message, sizeof message) == RACEWAY_DONE);
  CHECK(raceway_solve(model, rows, speed, axial, NULL, temperature, strides, &column, 1, torque,
                      NULL, message, sizeof message) == RACEWAY_DONE);
  for (size_t i = 0; i < rows; ++i) {
    CHECK(fabs(readings[i] - (2 * torque[i] + 7)) < 1e-9); /* two bearings, offset 7 N mm */
    snprintf(csv + strlen(csv), sizeof csv - strlen(csv), "%.17g,%.17g,%.17g,%.17g\n", speed[i],
             axial[i], temperature[i], readings[i]);
  }
  write_file("readings.csv", csv);
  char* json = printed("compare rig.toml readings.csv --json");
  CHECK(number_of(json, "rows") == rows);
  CHECK(number_of(json, "max_abs") < 1e-9); /* of 100 to 1000 N mm, written with all digits */
  free(json);
  raceway_free(model);
}

/* The bearing of the rig alone, without its rig and its effects, and more keys behind it. */
static const char* bearing_with(const char* more) {
  static char text[3000];
  snprintf(text, sizeof text, "%.*s%s", (int)(strstr(rig_text, "[rig]") - rig_text), rig_text,
           more);
  return text;
}

#define PAIR "[arrangement]\nlayout = \"O\"\nfront = 1\nrear = 1\nmounting = "

/* A spring keeps both bearings of a pair under its preload at every speed. */
static void a_pair_on_a_spring_has_the_torque_of_two_bearings(void) {
  enum { rows = 3 };
  const double speed[rows] = {500, 6000, 12000}, preload = 800, none = 0;
  const int strides[] = {1, 0, -1, -1}, column = 0;
  double one[rows], both[rows];
  char message[2000];
  raceway_model* single = model_of(bearing_with(""));
  raceway_model* pair = model_of(bearing_with(PAIR "\"spring\"\npreload_N = 800\n"));
  CHECK(raceway_solve(single, rows, speed, &preload, NULL, NULL, strides, &column, 1, one, NULL,
                      message, sizeof message) == RACEWAY_DONE);
  CHECK(raceway_solve(pair, rows, speed, &none, NULL, NULL, strides, &column, 1, both, NULL,
                      message, sizeof message) == RACEWAY_DONE);
  for (size_t i = 0; i < rows; ++i) CHECK(fabs(both[i] - 2 * one[i]) < 1e-7 * one[i]);
  raceway_free(single);
  raceway_free(pair);
}

/* The torque of a rigid pair is a record that the loop takes: the command predicts it without error
   and finds the preload of a model that has another one. */
static void torques_of_a_pair_are_a_record_that_tells_its_preload(void) {
  enum { rows = 12 };
  const double preload = 600;
  const int strides[] = {1, 1, -1, -1}, column = 0;
  double speed[rows], axial[rows], torque[rows], again[rows];
  char message[2000], csv[2000] = "speed_rpm,axial_load_N,friction_torque_Nmm\n";
  for (size_t i = 0; i < rows; ++i) {
    speed[i] = 500 + 2500 * (double)(i % 4);
    axial[i] = 400 * (double)(i / 4);
  }
  write_file("pair.toml", bearing_with(PAIR "\"rigid\"\npreload_N = 600\n"));
  write_file("loose.toml", bearing_with(PAIR "\"rigid\"\npreload_N = 400\n"
                                             "[calibration]\nfree = [\"preload_N\"]\n"));
  raceway_model* model = raceway_create_from_file("pair.toml", message, sizeof message);
  REQUIRE(model != NULL);
  CHECK(raceway_solve(model, rows, speed, axial, NULL, NULL, strides, &column, 1, torque, NULL,
                      message, sizeof message) == RACEWAY_DONE);
  raceway_free(model);
  for (size_t i = 0; i < rows; ++i)
    snprintf(csv + strlen(csv), sizeof csv - strlen(csv), "%.17g,%.17g,%.17g\n", speed[i], axial[i],
             torque[i]);
  write_file("torque.csv", csv);
  char* json = printed("compare pair.toml torque.csv --json");
  CHECK(strstr(json, "\"quantity\": \"friction_torque\"") != NULL);
  CHECK(number_of(json, "rows") == rows);
  CHECK(number_of(json, "max_abs") < 1e-6); /* of some 1000 N mm, by two solvers */
  free(json);
  json = printed("calibrate loose.toml torque.csv -o fitted.toml --json --force");
  const char* found = strstr(json, "\"preload_N\": {");
  REQUIRE(found != NULL);
  CHECK(fabs(number_of(found, "value") - preload) < 1e-3);
  free(json);
  model = raceway_create_from_file("fitted.toml", message, sizeof message);
  REQUIRE(model != NULL);
  CHECK(raceway_solve(model, rows, speed, axial, NULL, NULL, strides, &column, 1, again, NULL,
                      message, sizeof message) == RACEWAY_DONE);
  for (size_t i = 0; i < rows; ++i) CHECK(fabs(again[i] - torque[i]) < 1e-5 * torque[i]);
  raceway_free(model);
}

int main(int argc, char** argv) {
  if (argc != 3) return 1;
  program = argv[1];
  root = argv[2];
  char shaft[1000];
  snprintf(shaft, sizeof shaft, "%s/data/spindles/two_against_one.toml", root);
  write_file("rig.toml", rig_text);
  free(printed("new 'S 6014 C' -o contact.toml --force"));
  a_table_is_that_of_the_command("rig.toml", 0);
  a_table_is_that_of_the_command("contact.toml", 0);
  a_table_is_that_of_the_command(shaft, 1);
  const char* const of_rig[] = {"friction_torque_Nmm",        "power_loss_W",
                                "axial_displacement_um",      "inner_contact_pressure_MPa",
                                "outer_contact_pressure_MPa", "radial_displacement_z_um"};
  states_are_those_of_solve("rig.toml", "", 300, of_rig, 6);
  states_are_those_of_solve("contact.toml", "--axial-load 300", 300, of_rig, 6);
  const char* const of_shaft[] = {"axial_displacement_um", "front_force_N", "rear_force_N",
                                  "friction_torque_Nmm", "power_loss_W"};
  states_are_those_of_solve(shaft, "--axial-load 200", 200, of_shaft, 5);
  readings_are_those_that_compare_predicts();
  a_pair_on_a_spring_has_the_torque_of_two_bearings();
  torques_of_a_pair_are_a_record_that_tells_its_preload();
  return failures == 0 ? 0 : 1;
}
