#include <raceway/raceway.h>
#include <stdio.h>

int main(int argc, char** argv) {
  if (argc != 2) return 1;
  char message[1000];
  raceway_model* model = raceway_create_from_file(argv[1], message, sizeof message);
  if (model == NULL) {
    fprintf(stderr, "%s\n", message);
    return 1;
  }
  const double speed_rpm[] = {2000, 6000, 10000}, axial_load_N[] = {100, 600};
  const int torque = raceway_column_index(model, "friction_torque_Nmm");
  double values[6];
  const int result = raceway_table(model, speed_rpm, 3, axial_load_N, 2, NULL, 0, NULL, 0, &torque,
                                   1, values, NULL, message, sizeof message);
  for (int a = 0; result == RACEWAY_DONE && a < 2; ++a)
    for (int s = 0; s < 3; ++s)
      printf("%5.0f rpm %3.0f N %6.1f N mm\n", speed_rpm[s], axial_load_N[a], values[a * 3 + s]);
  if (message[0] != '\0') fprintf(stderr, "%s\n", message);
  raceway_free(model);
  return result;
}
