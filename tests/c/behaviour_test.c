/* What the C interface does with wrong input, with texts that are too short, and on threads. */
#include <math.h>
#include <pthread.h>

#include "tests/c/check.h"

static const char* program;

/* stderr of `raceway table` for a model of this text, without the last end of line. */
static const char* said_by_the_command(const char* file_name, const char* text, int status) {
  static char said[4000];
  char command[3000];
  write_file(file_name, text);
  snprintf(command, sizeof command, "'%s' table %s --speed 1000 >command.out 2>command.err",
           program, file_name);
  CHECK((system(command) != 0) == (status != 0));
  FILE* file = fopen("command.err", "r");
  REQUIRE(file != NULL);
  const size_t length = fread(said, 1, sizeof said - 1, file);
  fclose(file);
  said[length > 0 ? length - 1 : 0] = '\0';
  return said;
}

static void wrong_texts_are_refused_in_the_words_of_the_command(void) {
  const char* const texts[] = {"[bearing", "", "[bearing]\nball_count = -3\n",
                               "[bearing]\nname = \"\xff\"\n"};
  for (size_t i = 0; i < sizeof texts / sizeof *texts; ++i) {
    char message[4000];
    const char* said = said_by_the_command("wrong.toml", texts[i], 1);
    CHECK(raceway_create(texts[i], "wrong.toml", message, sizeof message) == NULL);
    CHECK_TEXT(message, said);
    CHECK(raceway_create_from_file("wrong.toml", message, sizeof message) == NULL);
    CHECK_TEXT(message, said);
    CHECK(strncmp(message, "wrong.toml", 10) == 0);
  }
  char message[200];
  CHECK(raceway_create_from_file("none.toml", message, sizeof message) == NULL);
  CHECK_TEXT(message, "none.toml: no such file");
  CHECK(raceway_create_from_file("-", message, sizeof message) == NULL);
  CHECK(strstr(message, "standard input") != NULL);
}

static void what_reading_said_can_be_asked_for(void) {
  raceway_model* model = model_of(rig_text);
  CHECK_TEXT(raceway_messages(model), said_by_the_command("my.toml", rig_text, 0));
  CHECK(strstr(raceway_messages(model), "; raceway check my.toml lists ") != NULL);
  raceway_free(model);
  /* Without effects the law takes no account of the balls. */
  char text[2000];
  snprintf(text, sizeof text, "%.*s", (int)(strstr(rig_text, "[[effect]]") - rig_text), rig_text);
  model = model_of(text);
  CHECK_TEXT(raceway_messages(model), said_by_the_command("my.toml", text, 0));
  CHECK(strstr(raceway_messages(model),
               "\nwarning: my.toml: the friction torque by palmgren does not depend on ") != NULL);
  raceway_free(model);
}

static void limits_of_running_bearings_are_warnings(void) {
  char message[1000];
  double speed = 1000, load = 30000, out[50];
  raceway_model* model = model_of(rig_text);
  CHECK(raceway_solve(model, 1, &speed, &load, NULL, NULL, NULL, NULL, 0, out, NULL, message,
                      sizeof message) == RACEWAY_DONE);
  CHECK(strstr(message, "GPa, above 2 GPa") != NULL);
  speed = 500000;
  CHECK(raceway_solve(model, 1, &speed, &load, NULL, NULL, NULL, NULL, 0, out, NULL, message,
                      sizeof message) == RACEWAY_WRONG_INPUT);
  CHECK(strstr(message, "above the upper limit, the inner ring bursts") != NULL);
  raceway_free(model);
}

static int is_utf8(const char* text) {
  for (const unsigned char* c = (const unsigned char*)text; *c != 0;) {
    const int more = *c < 0x80 ? 0 : *c >= 0xF0 ? 3 : *c >= 0xE0 ? 2 : 1;
    for (int i = 1; i <= more; ++i)
      if ((c[i] & 0xC0) != 0x80) return 0;
    c += more + 1;
  }
  return 1;
}

/* Of a name with characters of one to four bytes every length of the text. */
static void short_texts_end_between_characters(void) {
  char whole[400], cut[400];
  const char* name = "a\xC3\xB6\xE2\x82\xAC\xF0\x9F\x98\x80z.toml"; /* ö, euro sign, a face */
  CHECK(raceway_create("[bearing", name, whole, sizeof whole) == NULL);
  CHECK(strncmp(whole, name, strlen(name)) == 0);
  for (size_t size = 1; size <= strlen(whole) + 1; ++size) {
    memset(cut, 'x', sizeof cut);
    CHECK(raceway_create("[bearing", name, cut, size) == NULL);
    CHECK(strlen(cut) < size && strlen(cut) + 4 >= size);
    CHECK(strncmp(cut, whole, strlen(cut)) == 0 && is_utf8(cut));
    CHECK(cut[size] == 'x');
  }
  CHECK(raceway_create("[bearing", name, NULL, 100) == NULL);
  memset(cut, 'x', sizeof cut);
  CHECK(raceway_create("[bearing", name, cut, 0) == NULL);
  CHECK(cut[0] == 'x');
}

static void null_is_an_error_and_no_crash(void) {
  char message[400];
  double value = 1000, out[50];
  raceway_model* model = model_of(rig_text);
  CHECK(raceway_create(NULL, "x", message, sizeof message) == NULL);
  CHECK_TEXT(message, "toml_text is NULL");
  CHECK(raceway_create_from_file(NULL, message, sizeof message) == NULL);
  CHECK_TEXT(message, "path is NULL");
  raceway_free(NULL);
  CHECK_TEXT(raceway_messages(NULL), "");
  CHECK(raceway_column_count(NULL) == 0);
  CHECK(raceway_column_name(NULL, 0) == NULL);
  CHECK(raceway_column_index(NULL, "power_loss_W") == -1);
  CHECK(raceway_column_index(model, NULL) == -1);
  CHECK(raceway_solve(NULL, 1, &value, NULL, NULL, NULL, NULL, NULL, 0, out, NULL, message, 400) ==
        RACEWAY_WRONG_INPUT);
  CHECK_TEXT(message, "model is NULL");
  CHECK(raceway_solve(model, 1, &value, NULL, NULL, NULL, NULL, NULL, 0, NULL, NULL, message,
                      400) == RACEWAY_WRONG_INPUT);
  CHECK_TEXT(message, "values is NULL");
  CHECK(raceway_solve(model, 1, NULL, NULL, NULL, NULL, NULL, NULL, 0, out, NULL, message, 400) ==
        RACEWAY_WRONG_INPUT);
  CHECK_TEXT(message, "speed_rpm is missing");
  CHECK(raceway_table(NULL, &value, 1, NULL, 0, NULL, 0, NULL, 0, NULL, 0, out, NULL, message,
                      400) == RACEWAY_WRONG_INPUT);
  CHECK(raceway_table(model, NULL, 3, NULL, 0, NULL, 0, NULL, 0, NULL, 0, out, NULL, message,
                      400) == RACEWAY_WRONG_INPUT);
  CHECK_TEXT(message, "speed_rpm is NULL");
  CHECK(raceway_table(model, NULL, 0, NULL, 0, NULL, 0, NULL, 0, NULL, 0, out, NULL, message,
                      400) == RACEWAY_WRONG_INPUT);
  CHECK_TEXT(message, "speed_rpm is missing");
  CHECK(raceway_predict(NULL, 1, &value, NULL, NULL, NULL, NULL, out, NULL, message, 400) ==
        RACEWAY_WRONG_INPUT);
  CHECK(raceway_predict(model, 1, &value, NULL, NULL, NULL, NULL, NULL, NULL, message, 400) ==
        RACEWAY_WRONG_INPUT);
  CHECK_TEXT(message, "readings_Nmm is NULL");
  /* No states: nothing to do, and nothing is looked at. */
  CHECK(raceway_solve(model, 0, &value, NULL, NULL, NULL, NULL, NULL, 0, NULL, NULL, NULL, 0) ==
        RACEWAY_DONE);
  raceway_free(model);
}

static void wrong_numbers_are_named_with_their_place(void) {
  char message[400];
  const double speed[] = {1000, NAN, 3000}, negative[] = {100, 200, -1}, cold[] = {20, 20, -200};
  double out[200];
  const int beyond = 1000, below = -1;
  raceway_model* model = model_of(rig_text);
  memset(out, 0, sizeof out);
  CHECK(raceway_solve(model, 3, speed, NULL, NULL, NULL, NULL, NULL, 0, out, NULL, message, 400) ==
        RACEWAY_WRONG_INPUT);
  CHECK_TEXT(message, "speed_rpm[1] = nan rpm: must be from 0 to 1000000 rpm");
  CHECK(out[0] == 0.0); /* nothing written */
  CHECK(raceway_table(model, speed, 3, NULL, 0, NULL, 0, NULL, 0, NULL, 0, out, NULL, message,
                      400) == RACEWAY_WRONG_INPUT);
  CHECK_TEXT(message, "speed_rpm[1] = nan rpm: must be from 0 to 1000000 rpm");
  CHECK(raceway_table(model, speed, 1, negative, 3, NULL, 0, NULL, 0, NULL, 0, out, NULL, message,
                      400) == RACEWAY_WRONG_INPUT);
  CHECK(strstr(message, "axial_load_N[2] = -1") == message);
  CHECK(raceway_predict(model, 3, speed, NULL, NULL, cold, (const int[]){0, -1, -1, 1}, out, NULL,
                        message, 400) == RACEWAY_WRONG_INPUT);
  CHECK(strstr(message, "temperature_C[2] = -200") == message);
  CHECK(raceway_solve(model, 1, speed, NULL, NULL, NULL, NULL, &beyond, 1, out, NULL, message,
                      400) == RACEWAY_WRONG_INPUT);
  CHECK(strstr(message, "columns[0] = 1000: must be from 0 to ") == message);
  CHECK(raceway_solve(model, 1, speed, NULL, NULL, NULL, NULL, &below, 1, out, NULL, message,
                      400) == RACEWAY_WRONG_INPUT);
  CHECK(raceway_solve(model, (size_t)-1, speed, NULL, NULL, NULL, (const int[]){0, 0, 0, 0}, NULL,
                      0, out, NULL, message, 400) == RACEWAY_WRONG_INPUT);
  CHECK(strstr(message, "at most 1e+08 are allowed in one call") != NULL);
  CHECK(raceway_table(model, speed, (size_t)1 << 40, speed, (size_t)1 << 40, NULL, 0, NULL, 0, NULL,
                      0, out, NULL, message, 400) == RACEWAY_WRONG_INPUT);
  raceway_free(model);
}

static void a_state_without_balance_leaves_the_others(void) {
  char text[2000], message[400];
  snprintf(text, sizeof text, "%s[solver]\nrace_control = \"inner\"\n", rig_text);
  raceway_model* model = model_of(text);
  const double speed[] = {1000, 20000, 2000, 20000}, axial[] = {300, 5, 300, 5};
  const int torque = raceway_column_index(model, "friction_torque_Nmm");
  double values[4], readings[4];
  int status[4];
  CHECK(raceway_solve(model, 4, speed, axial, NULL, NULL, NULL, &torque, 1, values, status, message,
                      400) == RACEWAY_NOT_CONVERGED);
  CHECK(isfinite(values[0]) && isnan(values[1]) && isfinite(values[2]) && isnan(values[3]));
  CHECK(status[0] == RACEWAY_STATUS_CONVERGED && status[1] == RACEWAY_STATUS_NO_EQUILIBRIUM);
  CHECK_TEXT(message,
             "warning: 2 of 4 states have not converged: no_equilibrium; the first has index 1");
  CHECK(raceway_predict(model, 4, speed, axial, NULL, NULL, NULL, readings, status, message, 400) ==
        RACEWAY_NOT_CONVERGED);
  CHECK(isfinite(readings[0]) && isnan(readings[3]) && status[3] == RACEWAY_STATUS_NO_EQUILIBRIUM);
  CHECK_TEXT(raceway_status_name(status[1]), "no_equilibrium");
  CHECK_TEXT(raceway_status_name(RACEWAY_STATUS_NOT_RUN), "not_run");
  CHECK_TEXT(raceway_status_name(-1), "unknown");
  CHECK_TEXT(raceway_status_name(6), "unknown");
  raceway_free(model);
}

static void strides_pick_from_larger_arrays(void) {
  char message[400];
  raceway_model* model = model_of(rig_text);
  const double rows[] = {1000, 100, -7, 2000, 200, -7, 3000, 300, -7}; /* speed, load, else */
  const double speed[] = {1000, 2000, 3000}, axial[] = {100, 200, 300};
  const int strides[] = {3, 3, -1, -1}, torque = 0;
  double a[3], b[3];
  CHECK(raceway_solve(model, 3, rows, rows + 1, rows, NULL, strides, &torque, 1, a, NULL, message,
                      400) == RACEWAY_DONE);
  CHECK(raceway_solve(model, 3, speed, axial, NULL, NULL, NULL, &torque, 1, b, NULL, message,
                      400) == RACEWAY_DONE);
  CHECK(memcmp(a, b, sizeof a) == 0);
  /* A temperature in K is told. */
  const double kelvin = 313;
  CHECK(raceway_solve(model, 3, speed, axial, NULL, &kelvin, (const int[]){1, 1, -1, 0}, &torque, 1,
                      a, NULL, message, 400) == RACEWAY_DONE);
  CHECK(strncmp(message, "note: ", 6) == 0 && strstr(message, "temperature_C") != NULL);
  raceway_free(model);
}

static void a_reading_needs_a_rig_and_nothing_beside_the_state(const char* root) {
  char text[2000], message[600], path[1000];
  double speed = 1000, reading;
  snprintf(path, sizeof path, "%s/data/spindles/two_against_one.toml", root);
  raceway_model* shaft = raceway_create_from_file(path, message, sizeof message);
  REQUIRE(shaft != NULL);
  CHECK(raceway_predict(shaft, 1, &speed, NULL, NULL, NULL, NULL, &reading, NULL, message, 600) ==
        RACEWAY_WRONG_INPUT);
  CHECK(strstr(message, "has an [arrangement]") != NULL);
  CHECK(raceway_solve(shaft, 1, &speed, NULL, &speed, NULL, NULL, NULL, 0, &reading, NULL, message,
                      600) == RACEWAY_WRONG_INPUT);
  CHECK(strstr(message, "for a shaft, only axial_load_N is possible") != NULL);
  raceway_free(shaft);
  snprintf(text, sizeof text, "%s[[effect]]\nid = \"torque-time-drift\"\n", rig_text);
  raceway_model* drifting = model_of(text);
  CHECK(raceway_predict(drifting, 1, &speed, NULL, NULL, NULL, NULL, &reading, NULL, message,
                        600) == RACEWAY_WRONG_INPUT);
  CHECK_TEXT(message,
             "my.toml: the effect torque-time-drift needs time_s of every row, but a state has "
             "only speed, loads, moments and temperature");
  raceway_free(drifting);
}

static void columns_are_found_by_name(void) {
  raceway_model* model = model_of(rig_text);
  const size_t count = raceway_column_count(model);
  CHECK(count > 10);
  CHECK_TEXT(raceway_column_name(model, 0), "friction_torque_Nmm");
  for (size_t c = 0; c < count; ++c)
    CHECK(raceway_column_index(model, raceway_column_name(model, c)) == (int)c);
  CHECK(raceway_column_index(model, "axial_stiffness_N_um") > 0);
  CHECK(raceway_column_index(model, "none") == -1);
  CHECK(raceway_column_name(model, count) == NULL);
  CHECK(strchr(raceway_version(), '.') != NULL);
  raceway_free(model);
}

enum { states = 2000, rounds = 3 };

struct worker {
  const raceway_model* model;
  double* values; /* torque, reading, torque of a table */
  int failed;
};

static void* work(void* of) {
  struct worker* w = of;
  double speed[states], axial = 300;
  const int torque = 0, strides[] = {1, 0, -1, -1};
  char message[400];
  for (int i = 0; i < states; ++i) speed[i] = 100 + 7 * i;
  for (int round = 0; round < rounds; ++round) {
    if (raceway_solve(w->model, states, speed, &axial, NULL, NULL, strides, &torque, 1, w->values,
                      NULL, message, sizeof message) != RACEWAY_DONE ||
        raceway_predict(w->model, states, speed, &axial, NULL, NULL, strides, w->values + states,
                        NULL, message, sizeof message) != RACEWAY_DONE ||
        raceway_table(w->model, speed, states, &axial, 1, NULL, 0, NULL, 0, &torque, 1,
                      w->values + 2 * states, NULL, message, sizeof message) != RACEWAY_DONE)
      ++w->failed;
    /* Another model comes and goes, and this one has a wrong question in between. */
    raceway_free(raceway_create(rig_text, "other.toml", message, sizeof message));
    if (raceway_solve(w->model, 1, NULL, NULL, NULL, NULL, NULL, NULL, 0, w->values, NULL, message,
                      sizeof message) != RACEWAY_WRONG_INPUT ||
        strcmp(message, "speed_rpm is missing") != 0)
      ++w->failed;
  }
  return NULL;
}

static void threads_share_a_model(void) {
  enum { threads = 4 };
  raceway_model* model = model_of(rig_text);
  pthread_t thread[threads];
  struct worker workers[threads + 1];
  for (int t = 0; t <= threads; ++t) {
    workers[t] = (struct worker){model, malloc(3 * states * sizeof(double)), 0};
    REQUIRE(workers[t].values != NULL);
  }
  work(&workers[threads]); /* alone */
  for (int t = 0; t < threads; ++t)
    REQUIRE(pthread_create(&thread[t], NULL, work, &workers[t]) == 0);
  for (int t = 0; t < threads; ++t) pthread_join(thread[t], NULL);
  for (int t = 0; t <= threads; ++t) {
    CHECK(workers[t].failed == 0);
    CHECK(memcmp(workers[t].values, workers[threads].values, 3 * states * sizeof(double)) == 0);
    if (t < threads) free(workers[t].values);
  }
  CHECK(memcmp(workers[threads].values, workers[threads].values + 2 * states,
               states * sizeof(double)) == 0); /* a table of one load is these states */
  free(workers[threads].values);
  raceway_free(model);
}

int main(int argc, char** argv) {
  if (argc != 3) return 1;
  program = argv[1];
  wrong_texts_are_refused_in_the_words_of_the_command();
  what_reading_said_can_be_asked_for();
  limits_of_running_bearings_are_warnings();
  short_texts_end_between_characters();
  null_is_an_error_and_no_crash();
  wrong_numbers_are_named_with_their_place();
  a_state_without_balance_leaves_the_others();
  strides_pick_from_larger_arrays();
  a_reading_needs_a_rig_and_nothing_beside_the_state(argv[2]);
  columns_are_found_by_name();
  threads_share_a_model();
  return failures == 0 ? 0 : 1;
}
