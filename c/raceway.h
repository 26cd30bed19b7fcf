/// Friction of spindle bearings for C, Fortran, MATLAB, Octave, LabVIEW, Modelica: models are read
/// from TOML (docs/files.md), states go in as plain arrays, results come out as plain arrays.
///
/// Units:    given in the names, as in files: rpm, N, C, N mm.
/// Returns:  0 done, 1 wrong input, 2 some states without a result, as the command raceway.
/// Messages: a function that takes `message` and `message_size` writes its message there, in UTF-8
///           with a final 0: the error in the words of the command, or notes and warnings, a line
///           each ("note: ...", "warning: ..."), or an empty text. Text that does not fit is cut
///           off, never within a character. NULL or a size of 0: no text.
/// Threads:  all functions may be called from any number of threads at once, with the same model
///           too: a model does not change. raceway_free() alone must come last, and once.
/// Errors:   no function throws, prints or ends the program. Without enough memory: 1 or NULL.
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

/// A loaded model: a bearing on a rig, the bearing sets of a shaft, or a spindle, whose sets are
/// solved as for a shaft.
typedef struct raceway_model raceway_model;

/// Return values of the functions.
enum { RACEWAY_DONE = 0, RACEWAY_WRONG_INPUT = 1, RACEWAY_NOT_CONVERGED = 2 };

/// Solution status of a state; raceway_status_name() gives the words.
enum {
  RACEWAY_STATUS_CONVERGED = 0,
  RACEWAY_STATUS_NO_EQUILIBRIUM = 1,  ///< no equilibrium with this load
  RACEWAY_STATUS_ITERATION_LIMIT = 2,
  RACEWAY_STATUS_SINGULAR = 3,    ///< the load leaves a displacement undetermined
  RACEWAY_STATUS_NOT_FINITE = 4,  ///< the numbers left the range of doubles
  RACEWAY_STATUS_NOT_RUN = 5
};

/// Version of the library, as "0.2.0". Static: do not free it.
RACEWAY_API const char* raceway_version(void);

/// Returns a status as in tables and JSON, such as "no_equilibrium"; "unknown" for other numbers.
/// Static: do not free it.
RACEWAY_API const char* raceway_status_name(int status);

/// Reads a model from the text of a model file. `source_name` stands for the file in messages;
/// NULL: "model". Files that the text names are looked for as from a file of that name.
///
/// Returns the model, to be given to raceway_free(), or NULL; then `message` says why. Of a model
/// that could be read raceway_messages() has the notes.
RACEWAY_API raceway_model* raceway_create(const char* toml_text, const char* source_name,
                                          char* message, size_t message_size);

/// Reads a model from a file, otherwise as raceway_create(). "-" is an error: standard input
/// belongs to the calling program.
RACEWAY_API raceway_model* raceway_create_from_file(const char* path, char* message,
                                                    size_t message_size);

/// Frees a model, which must not be used afterwards. NULL does nothing.
RACEWAY_API void raceway_free(raceway_model* model);

/// Notes from reading the model, such as the number of defaults used and doubtful values. Format as
/// `message` above; valid as long as the model. Empty for NULL.
RACEWAY_API const char* raceway_messages(const raceway_model* model);

/// Number of result columns of raceway_solve() and raceway_table(); 0 for NULL.
RACEWAY_API size_t raceway_column_count(const raceway_model* model);

/// Name of a column with its unit, as "power_loss_W"; columns count from 0, the first is
/// "friction_torque_Nmm", for a shaft the total of all its bearings. Valid as long as the model.
/// NULL for a column that does not exist.
RACEWAY_API const char* raceway_column_name(const raceway_model* model, size_t column);

/// Index of the column with this name; -1 if there is none.
RACEWAY_API int raceway_column_index(const raceway_model* model, const char* name);

/// Solves `count` states of a bearing, or of a shaft, side by side on all cores. Neither the number
/// of threads nor the other states change a digit.
///
/// speed_rpm ... temperature_C  the states. NULL: the model's own value, as the command has it
///           without that flag; speed_rpm must be given. Axial loads of a shaft are external,
///           positive towards the tool; it takes no radial load.
/// strides   4 numbers in the order of these arrays: from one state to the next so many doubles.
///           1: an array of `count` numbers. 0: one number for all states. Negative: not given, as
///           NULL, for languages without one. NULL: all are 1.
/// columns   `column_count` columns to compute, from raceway_column_index(). NULL or a count
///           of 0: all, in their order.
/// values    [count x columns], column behind column: state i of the j-th wanted column
///           is values[j * count + i], in Fortran and MATLAB values(i, j). NaN where there is none.
/// status    [count], a number of raceway_status_name(); NULL: not wanted.
///
/// Returns RACEWAY_DONE; RACEWAY_WRONG_INPUT with nothing written: a NULL where none may be, a
/// number out of its range (its place, from 0, stands in the message), no axial load; more than 1e8
/// states; RACEWAY_NOT_CONVERGED where a status is another than converged, with all others as they
/// should be. A law that needs no balls has a torque even where these find no balance.
RACEWAY_API int raceway_solve(const raceway_model* model, size_t count, const double* speed_rpm,
                              const double* axial_load_N, const double* radial_load_N,
                              const double* temperature_C, const int* strides, const int* columns,
                              size_t column_count, double* values, int* status, char* message,
                              size_t message_size);

/// A Stribeck table: raceway_solve() at all points of a grid, with the numbers and in the order of
/// `raceway table --format plain`.
///
/// speed_rpm ... temperature_C  the axes, each with its number of values. A count of 0: the model's
///           own value, a single one; speed_rpm must be given.
/// values    [speeds x axial loads x radial loads x temperatures x columns], the first running
///           fastest: of speed s, axial load a, radial load r and temperature t the point is
///           i = ((t * radial_loads + r) * axial_loads + a) * speeds + s, and its j-th wanted
///           column values[j * points + i]; in Fortran and MATLAB values(s, a, r, t, j).
/// status    [points] or NULL.
///
/// Columns, returns and errors as in raceway_solve().
RACEWAY_API int raceway_table(const raceway_model* model, const double* speed_rpm,
                              size_t speed_count, const double* axial_load_N,
                              size_t axial_load_count, const double* radial_load_N,
                              size_t radial_load_count, const double* temperature_C,
                              size_t temperature_count, const int* columns, size_t column_count,
                              double* values, int* status, char* message, size_t message_size);

/// Predicts the reading of a rig [N mm]: friction torque of all its bearings (`bearings` under
/// [rig]), with the effects of the model on the sensor; the column friction_torque_Nmm is for one
/// bearing, without them. Balls are solved for only where the model needs them, so it is several
/// times faster than raceway_solve().
///
/// States, strides, returns and errors as in raceway_solve(). `readings_Nmm` [count],
/// `status` [count] or NULL. A shaft, or a model with an effect that needs an input that states
/// lack, as a time, is wrong input, too.
RACEWAY_API int raceway_predict(const raceway_model* model, size_t count, const double* speed_rpm,
                                const double* axial_load_N, const double* radial_load_N,
                                const double* temperature_C, const int* strides,
                                double* readings_Nmm, int* status, char* message,
                                size_t message_size);

#ifdef __cplusplus
}
#endif

#endif
