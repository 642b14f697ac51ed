#ifndef asperity_base_exit_status_h
#define asperity_base_exit_status_h

namespace asperity
{
  /** What a command returns to the shell. */
  enum ExitStatus : int
  {
    success            = 0,
    computation_failed = 1,
    input_is_wrong     = 2
  };
} // namespace asperity

#endif
