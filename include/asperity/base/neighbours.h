#ifndef asperity_base_neighbours_h
#define asperity_base_neighbours_h

/**
 * Numbers that lie side by side in memory as one vector, so that an inner loop
 * is one instruction for several of them; lanes.h has the functions of numbers
 * that are side by side in registers.
 */
namespace asperity::neighbours
{
  /** Need not be aligned as a whole. */
  using Pack = double
    __attribute__((vector_size(32), aligned(alignof(double)), may_alias));

  /** Numbers of a pack, to a multiple of which rows are padded. */
  constexpr unsigned int width = sizeof(Pack) / sizeof(double);

  constexpr unsigned int
  padded(const unsigned int n)
  {
    return (n + width - 1) / width * width;
  }

  /** The pack that begins at x. */
  inline const Pack &
  at(const double *x)
  {
    return *(const Pack *)x;
  }

  inline Pack &
  at(double *x)
  {
    return *(Pack *)x;
  }

  /** For rows in which both components of vectors lie side by side. */
  inline Pack
  alternate(const double x, const double y)
  {
    return Pack{x, y, x, y};
  }
} // namespace asperity::neighbours

#endif
