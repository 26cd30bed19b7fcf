/// Interface to the friction of spindle bearings for C, Fortran, MATLAB, Octave, LabVIEW and
/// Modelica. Models are read from TOML (docs/files.md). A state is an operating point: speed, loads
/// and temperature. States and results are plain arrays.
///
/// Units:    the name of a quantity ends with its unit, such as rpm, N, C (degrees Celsius) or Nmm
///           (N mm).
/// Returns:  raceway_solve(), raceway_table() and raceway_predict() return 0: done, 1: wrong input,
///           2: some states did not converge. The exit status of the command raceway has the same
///           meaning.
/// Messages: a function with `message` and `message_size` writes its message into the buffer
///           `message`, in UTF-8 with a final zero byte. The message is the error text, or one line
///           for each note and warning ("note: ...", "warning: ..."), or empty. Text that does not
///           fit is cut off between two characters. With NULL or a size of 0, no text is written.
/// Threads:  several threads may call the functions at the same time, even with the same model,
///           because a model does not change. Call raceway_free() once for each model, after all
///           other calls with this model.
/// Errors:   no function throws, prints or ends the program. If memory runs out, raceway_create()
///           and raceway_create_from_file() return NULL, and the functions under "Returns" return
///           1.
#ifndef RACEWAY_RACEWAY_H
#define RACEWAY_RACEWAY_H

#include <stddef.h>

#if defined(__GNUC__)
#define RACEWAY_API __attribute__((visibility("default")))
#else
#define RACEWAY_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// A loaded model: a bearing on a rig, the bearing sets of a shaft, or a spindle. For a spindle,
/// the functions solve only the bearing sets, in the same way as for a shaft.
typedef struct raceway_model raceway_model;

/// Return values of the functions.
enum { RACEWAY_DONE = 0, RACEWAY_WRONG_INPUT = 1, RACEWAY_NOT_CONVERGED = 2 };

/// Solution status of a state. raceway_status_name() returns its name.
enum {
  RACEWAY_STATUS_CONVERGED = 0,
  RACEWAY_STATUS_NO_EQUILIBRIUM = 1,  ///< no equilibrium was found under this load
  RACEWAY_STATUS_ITERATION_LIMIT = 2,
  RACEWAY_STATUS_SINGULAR = 3,    ///< singular stiffness: a displacement is undetermined
  RACEWAY_STATUS_NOT_FINITE = 4,  ///< a result is infinite or NaN
  RACEWAY_STATUS_NOT_RUN = 5
};

/// Returns the version of the library, such as "0.2.0". The text is static: do not free it.
RACEWAY_API const char* raceway_version(void);

/// Returns the name of a status, such as "no_equilibrium". Returns "unknown" for a number that is
/// not a RACEWAY_STATUS constant. The text is static: do not free it.
RACEWAY_API const char* raceway_status_name(int status);

/// Reads a model from the text of a model file. `source_name` is the name of the file in messages;
/// NULL means "model". Names of files in the text are relative to the folder of `source_name`.
///
/// Returns the model. Free the model with raceway_free(). After an error, the function returns
/// NULL, and `message` gives the reason. raceway_messages() returns the notes on a model that was
/// read.
RACEWAY_API raceway_model* raceway_create(const char* toml_text, const char* source_name,
                                          char* message, size_t message_size);

/// Reads a model from a file, otherwise like raceway_create(). The path "-" is an error: the
/// function does not read standard input.
RACEWAY_API raceway_model* raceway_create_from_file(const char* path, char* message,
                                                    size_t message_size);

/// Frees a model. Do not use the model afterwards. A call with NULL does nothing.
RACEWAY_API void raceway_free(raceway_model* model);

/// Returns the notes and warnings from reading the model, such as the number of default values, one
/// per line. The text is valid until the model is freed. The text is empty if `model` is NULL.
RACEWAY_API const char* raceway_messages(const raceway_model* model);

/// Returns the number of result columns of raceway_solve() and raceway_table(); 0 if `model` is
/// NULL.
RACEWAY_API size_t raceway_column_count(const raceway_model* model);

/// Returns the name of a column with its unit, such as "power_loss_W"; NULL for a column that does
/// not exist. Column 0 is "friction_torque_Nmm". For a shaft, this torque is the sum over all
/// bearings. The name is valid until the model is freed.
RACEWAY_API const char* raceway_column_name(const raceway_model* model, size_t column);

/// Returns the index of the column with this name; -1 if the model has no such column.
RACEWAY_API int raceway_column_index(const raceway_model* model, const char* name);

/// Solves `count` states of a bearing or of a shaft, in parallel on all cores. The results of a
/// state do not depend on the number of threads or on the other states.
///
/// speed_rpm ... temperature_C  the states, in four arrays. If an array of loads or temperatures is
///           NULL, the value of the model is used. speed_rpm is required. Axial loads of a shaft
///           are external loads, positive towards the tool. Radial loads are not allowed for a
///           shaft.
/// strides   four numbers, one for each of these arrays in their order: the distance from one state
///           to the next, counted in doubles. With a stride of 1, the array has `count` numbers.
///           With 0, one number is used for all states. A negative stride has the same meaning as a
///           NULL array, for languages without NULL. If `strides` is NULL, all strides are 1.
/// columns   indices of the `column_count` columns to compute, from raceway_column_index(). With
///           NULL or a count of 0, all columns are computed, in their order.
/// values    [count x columns], one column after the other: state i of the j-th given column is
///           values[j * count + i], in Fortran and MATLAB values(i, j). A result that cannot be
///           computed is NaN.
/// status    [count] RACEWAY_STATUS constants, or NULL if you do not need them.
///
/// Returns RACEWAY_DONE if all states converged. Returns RACEWAY_WRONG_INPUT and writes no values
/// for a required pointer that is NULL, a number out of range (the message gives its index, counted
/// from 0), an axial load that neither the call nor the model gives, or more than 1e8 states.
/// Returns RACEWAY_NOT_CONVERGED if the status of a state is not RACEWAY_STATUS_CONVERGED. The
/// results of the converged states are valid. If neither the friction law nor an effect uses ball
/// loads or angles, the torque of a bearing is computed even if the balls have no equilibrium.
RACEWAY_API int raceway_solve(const raceway_model* model, size_t count, const double* speed_rpm,
                              const double* axial_load_N, const double* radial_load_N,
                              const double* temperature_C, const int* strides, const int* columns,
                              size_t column_count, double* values, int* status, char* message,
                              size_t message_size);

/// Computes a Stribeck table: raceway_solve() at all points of a grid, with the same values in the
/// same order as `raceway table --format plain`.
///
/// speed_rpm ... temperature_C  the axes, each with its number of values. If the number of loads or
///           temperatures is 0, the single value of the model is used. speed_rpm is required.
/// values    [speeds x axial loads x radial loads x temperatures x columns]. The speed varies
///           fastest. The point of speed s, axial load a, radial load r and temperature t is
///           i = ((t * radial_loads + r) * axial_loads + a) * speeds + s. The j-th given column of
///           this point is values[j * points + i], in Fortran and MATLAB values(s, a, r, t, j).
/// status    [points] RACEWAY_STATUS constants, or NULL.
///
/// Columns, return values and errors are as in raceway_solve().
RACEWAY_API int raceway_table(const raceway_model* model, const double* speed_rpm,
                              size_t speed_count, const double* axial_load_N,
                              size_t axial_load_count, const double* radial_load_N,
                              size_t radial_load_count, const double* temperature_C,
                              size_t temperature_count, const int* columns, size_t column_count,
                              double* values, int* status, char* message, size_t message_size);

/// Predicts the reading of a rig [N mm]: the friction torque of all its bearings (`bearings` under
/// [rig]) with the effects of the model on the sensor. The column friction_torque_Nmm of
/// raceway_solve() is for one bearing, without effects on the sensor. raceway_predict() solves the
/// equilibrium of the balls only if the friction law or an effect uses ball loads or angles. For
/// other models, raceway_predict() is several times faster than raceway_solve().
///
/// States, strides, return values and errors are as in raceway_solve(). `readings_Nmm` receives
/// `count` values. `status` receives `count` values or is NULL. The function returns
/// RACEWAY_WRONG_INPUT for a shaft and for a model with an effect that needs further inputs, such
/// as time.
RACEWAY_API int raceway_predict(const raceway_model* model, size_t count, const double* speed_rpm,
                                const double* axial_load_N, const double* radial_load_N,
                                const double* temperature_C, const int* strides,
                                double* readings_Nmm, int* status, char* message,
                                size_t message_size);

#ifdef __cplusplus
}
#endif

#endif
