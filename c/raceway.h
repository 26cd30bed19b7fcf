/// Calculates the friction of spindle bearings, for programs in C, Fortran, MATLAB, Octave, LabVIEW
/// and Modelica. Models are read from TOML (docs/files.md). A state is an operating point: speed,
/// loads and temperature. States and results are plain arrays.
///
/// Units:    the name of a quantity ends with its unit, such as rpm, N, C (degrees Celsius) or Nmm
///           (N mm).
/// Returns:  raceway_solve(), raceway_table() and raceway_predict() return RACEWAY_DONE (0),
///           RACEWAY_WRONG_INPUT (1), or RACEWAY_NOT_CONVERGED (2) if some states did not converge.
///           The exit status of the program raceway has the same meaning.
/// Messages: a function with `message` and `message_size` writes its message into the buffer
///           `message`, in UTF-8 with a final zero byte. The message contains the error text, or
///           one line for each note and warning ("note: ...", "warning: ..."). If there is no
///           error, note or warning, the message is empty. If the buffer is too small, the text is
///           cut off after a complete character. If `message` is NULL or `message_size` is 0, no
///           text is written.
/// Threads:  several threads may call the functions at the same time, even with the same model,
///           because the functions do not change a model. Call raceway_free() once for each model,
///           after all other calls with this model.
/// Errors:   no function throws, prints or ends the program. If memory runs out, raceway_create()
///           and raceway_create_from_file() return NULL, and the functions under "Returns" return
///           RACEWAY_WRONG_INPUT.
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

/// Result of the solver for one state. raceway_status_name() returns the name of a status.
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
/// NULL, and `message` gives the reason. raceway_messages() returns the notes on the model.
RACEWAY_API raceway_model* raceway_create(const char* toml_text, const char* source_name,
                                          char* message, size_t message_size);

/// Reads a model from a file. The return value and the errors are as for raceway_create(). The path
/// "-" is an error, because the function does not read standard input.
RACEWAY_API raceway_model* raceway_create_from_file(const char* path, char* message,
                                                    size_t message_size);

/// Frees a model. Do not use the model afterwards. If `model` is NULL, the function does nothing.
RACEWAY_API void raceway_free(raceway_model* model);

/// Returns the notes and warnings that arose when the model was read, one per line, such as the
/// number of default values. The text is valid until the model is freed. The text is empty if
/// `model` is NULL.
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
/// strides   four numbers, one for each array of the states, in the order of these arguments. A
///           stride is the distance from one state to the next, counted in doubles. With a stride
///           of 1, the array has `count` numbers. With a stride of 0, the array has one number for
///           all states. In languages without NULL, use a negative stride instead of a NULL array.
///           If `strides` is NULL, all strides are 1.
/// columns   indices of the columns to compute, from raceway_column_index(). `column_count` is the
///           number of indices. If `columns` is NULL or `column_count` is 0, all columns are
///           computed, in the order of their indices.
/// values    [count x columns], one column after the other. The result of state i in the j-th given
///           column is values[j * count + i], with i and j from 0. In Fortran and MATLAB, this
///           result is values(i, j), with i and j from 1. A result that cannot be computed is NaN.
/// status    [count] RACEWAY_STATUS constants, or NULL if you do not need them.
///
/// Returns RACEWAY_DONE if all states converged. Returns RACEWAY_NOT_CONVERGED if a state did not
/// converge; the results of the converged states are valid. Returns RACEWAY_WRONG_INPUT and writes
/// no values in these cases: a required pointer is NULL, a number is out of range, neither the call
/// nor the model gives an axial load, or there are more than 1e8 states. For a number out of range,
/// the message gives the index of the number, counted from 0. If neither the friction law nor an
/// effect uses ball loads or angles, the torque of a bearing is computed even if the balls have no
/// equilibrium.
RACEWAY_API int raceway_solve(const raceway_model* model, size_t count, const double* speed_rpm,
                              const double* axial_load_N, const double* radial_load_N,
                              const double* temperature_C, const int* strides, const int* columns,
                              size_t column_count, double* values, int* status, char* message,
                              size_t message_size);

/// Computes a Stribeck table: raceway_solve() at all points of a grid, with the same values and the
/// same order of points as `raceway table --format plain`.
///
/// speed_rpm ... temperature_C  the axes of the grid. Each axis is an array, followed by its number
///           of values. If the number of loads or temperatures is 0, the value of the model is
///           used. speed_rpm is required.
/// values    [speeds x axial loads x radial loads x temperatures x columns]. The speed varies
///           fastest. The point with the indices s, a, r and t of speed, axial load, radial load
///           and temperature has the index
///           i = ((t * radial_loads + r) * axial_loads + a) * speeds + s. The result of this point
///           in the j-th given column is values[j * points + i]. All indices are counted from 0. In
///           Fortran and MATLAB, this result is values(s, a, r, t, j), with indices from 1.
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
/// [rig]), changed by the effects of the model that act on the sensor. The column
/// friction_torque_Nmm of raceway_solve() is for one bearing, without effects on the sensor.
/// raceway_predict() solves the equilibrium of the balls only if the friction law or an effect uses
/// ball loads or angles. For models that do not use ball loads or angles, raceway_predict() is
/// several times faster than raceway_solve().
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
