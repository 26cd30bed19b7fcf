/*
 * Stribeck tables in Octave and MATLAB.
 *
 *   [values, columns, status] = raceway_table (model_file, speed_rpm, axial_load_N,
 *                                              radial_load_N, temperature_C)
 *
 * Axes are real doubles; [] and axes left out are the model's own value. `values` is speeds x axial
 * loads x radial loads x temperatures x columns, `columns` their names with units, the first
 * friction_torque_Nmm, so that values(:, :, 1, 1, 1) is the torque over speed and axial load;
 * `status` (int32) is 0 where a point has converged. Numbers are those of `raceway table`. Without
 * outputs the torque is printed. Wrong input is an error with the words of the command, identifier
 * raceway:input; points without balance are a warning, raceway:status.
 *
 * Octave: mkoctfile --mex -o raceway_table raceway_mex.c $(pkg-config --cflags --libs raceway)
 * MATLAB: mex -output raceway_table raceway_mex.c -Iprefix/include -Lprefix/lib -lraceway_c
 */
#include <mex.h>
#include <raceway/raceway.h>
#include <string.h>

enum { axes = 4, message_size = 8000 };

typedef struct {
  const double* values[axes];
  size_t counts[axes];
  mwSize dimensions[axes + 1]; /* at least 1; the last is that of the columns */
} grid;

static const char* const axis_names[axes] = {"speed_rpm", "axial_load_N", "radial_load_N",
                                             "temperature_C"};

static void refuse(const char* what, const char* why) {
  mexErrMsgIdAndTxt("raceway:input", "%s%s", what, why);
}

static grid grid_of(int count, const mxArray* const* arguments) {
  grid g;
  for (int k = 0; k < axes; ++k) {
    g.values[k] = NULL;
    g.counts[k] = 0;
    if (k < count) {
      const mxArray* given = arguments[k];
      if (!mxIsDouble(given) || mxIsComplex(given) || mxIsSparse(given))
        refuse(axis_names[k], ": must be an array of real doubles");
      g.values[k] = mxGetPr(given);
      g.counts[k] = mxGetNumberOfElements(given);
    }
    g.dimensions[k] = (mwSize)(g.counts[k] > 0 ? g.counts[k] : 1);
  }
  return g;
}

static raceway_model* open_model(const mxArray* file) {
  static const char wrong[] = "model_file: must be the name of a file";
  if (!mxIsChar(file) || mxGetNumberOfElements(file) == 0 || mxGetM(file) != 1) refuse(wrong, "");
  char* path = mxArrayToString(file);
  if (path == NULL) refuse(wrong, "");
  char message[message_size];
  raceway_model* model = raceway_create_from_file(path, message, sizeof message);
  mxFree(path);
  if (model == NULL) refuse(message, "");
  return model;
}

/* Speed down, axial load across, a block for each radial load and temperature. */
static void print(const grid* g, const double* torque) {
  const mwSize speeds = g->dimensions[0], loads = g->dimensions[1];
  for (mwSize block = 0; block < g->dimensions[2] * g->dimensions[3]; ++block) {
    mexPrintf("Friction torque [N mm], speed [rpm] down, axial load [N] across");
    if (g->counts[2] > 0) mexPrintf(", radial load %g N", g->values[2][block % g->dimensions[2]]);
    if (g->counts[3] > 0) mexPrintf(", %g C", g->values[3][block / g->dimensions[2]]);
    mexPrintf("\n%10s", "");
    for (mwSize a = 0; a < loads; ++a)
      if (g->counts[1] > 0)
        mexPrintf(" %10g", g->values[1][a]);
      else
        mexPrintf(" %10s", "of model");
    for (mwSize s = 0; s < speeds; ++s) {
      mexPrintf("\n%10g", g->values[0][s]);
      for (mwSize a = 0; a < loads; ++a)
        mexPrintf(" %10.4g", torque[(block * loads + a) * speeds + s]);
    }
    mexPrintf("\n");
  }
}

static mxArray* names_of(const raceway_model* model) {
  const size_t count = raceway_column_count(model);
  mxArray* names = mxCreateCellMatrix(1, (mwSize)count);
  for (size_t c = 0; c < count; ++c)
    mxSetCell(names, (mwIndex)c, mxCreateString(raceway_column_name(model, c)));
  return names;
}

void mexFunction(int output_count, mxArray* outputs[], int input_count, const mxArray* inputs[]) {
  if (input_count < 2 || input_count > 1 + axes || output_count > 3)
    refuse("[values, columns, status] = ",
           "raceway_table (model_file, speed_rpm, axial_load_N, radial_load_N, temperature_C)");
  grid g = grid_of(input_count - 1, inputs + 1);
  raceway_model* model = open_model(inputs[0]);
  g.dimensions[axes] = (mwSize)raceway_column_count(model);
  mxArray* values = mxCreateNumericArray(axes + 1, g.dimensions, mxDOUBLE_CLASS, mxREAL);
  mxArray* status = mxCreateNumericArray(axes, g.dimensions, mxINT32_CLASS, mxREAL);
  mxArray* names = names_of(model);
  char notes[message_size] = "", message[message_size];
  strncat(notes, raceway_messages(model), sizeof notes - 1);
  const int result =
      raceway_table(model, g.values[0], g.counts[0], g.values[1], g.counts[1], g.values[2],
                    g.counts[2], g.values[3], g.counts[3], NULL, 0, mxGetPr(values),
                    (int*)mxGetData(status), message, sizeof message);
  raceway_free(model);
  if (result == RACEWAY_WRONG_INPUT) refuse(message, "");
  if (output_count == 0) {
    if (notes[0] != '\0') mexPrintf("%s\n", notes);
    print(&g, mxGetPr(values));
  }
  /* Octave puts the word warning before it. */
  const char* doubt = strncmp(message, "warning: ", 9) == 0 ? message + 9 : message;
  if (doubt[0] != '\0')
    mexWarnMsgIdAndTxt(result == RACEWAY_DONE ? "raceway:note" : "raceway:status", "%s", doubt);
  mxArray* const all[] = {values, names, status};
  for (int i = 0; i < 3; ++i)
    if (i < output_count)
      outputs[i] = all[i];
    else
      mxDestroyArray(all[i]);
}
