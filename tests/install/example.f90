program friction
  use, intrinsic :: iso_c_binding
  implicit none
  interface
    function raceway_create_from_file(path, message, message_size) bind(c) result(model)
      import
      character(kind=c_char), intent(in) :: path(*)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: message_size
      type(c_ptr) :: model
    end function
    function raceway_column_index(model, name) bind(c) result(column)
      import
      type(c_ptr), value :: model
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int) :: column
    end function
    function raceway_solve(model, count, speed_rpm, axial_load_N, radial_load_N, temperature_C, strides, &
                           columns, column_count, values, status, message, message_size) bind(c) result(done)
      import
      type(c_ptr), value :: model
      integer(c_size_t), value :: count, column_count, message_size
      real(c_double), intent(in) :: speed_rpm(*), axial_load_N(*), radial_load_N(*), temperature_C(*)
      integer(c_int), intent(in) :: strides(4), columns(*)
      real(c_double), intent(out) :: values(*)
      integer(c_int), intent(out) :: status(*)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_int) :: done
    end function
    subroutine raceway_free(model) bind(c)
      import
      type(c_ptr), value :: model
    end subroutine
  end interface

  real(c_double) :: speed(3) = [2000, 6000, 10000], load(1) = [600], own(1) = [0], values(3, 2)
  integer(c_int) :: status(3), columns(2), done
  ! One load for all speeds; radial load and temperature are those of the model.
  integer(c_int) :: strides(4) = [1, 0, -1, -1]
  character(kind=c_char) :: message(1000)
  character(len=500) :: path
  type(c_ptr) :: model
  integer :: i

  call get_command_argument(1, path)
  model = raceway_create_from_file(trim(path)//c_null_char, message, size(message, kind=c_size_t))
  if (.not. c_associated(model)) then
    call say()
    stop 1
  end if
  columns(1) = raceway_column_index(model, 'friction_torque_Nmm'//c_null_char)
  columns(2) = raceway_column_index(model, 'axial_displacement_um'//c_null_char)
  done = raceway_solve(model, 3_c_size_t, speed, load, own, own, strides, columns, 2_c_size_t, values, &
                       status, message, size(message, kind=c_size_t))
  call say()
  if (done /= 1) print '(f6.0, " rpm", f8.1, " N mm", f8.2, " um")', (speed(i), values(i, :), i=1, 3)
  call raceway_free(model)
  if (done /= 0) stop 1

contains

  subroutine say()  ! what stands before the final 0
    integer :: k
    do k = 1, size(message)
      if (message(k) == c_null_char) exit
      write (*, '(a)', advance='no') message(k)
    end do
    if (k > 1) print *
  end subroutine
end program
