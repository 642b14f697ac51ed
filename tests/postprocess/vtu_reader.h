#ifndef tests_postprocess_vtu_reader_h
#define tests_postprocess_vtu_reader_h

#include <string>
#include <vector>

/** What a visualisation program finds in a VTU file. */
class VtuReader
{
public:
  explicit VtuReader(const std::string &content);

  /** Three coordinates a point. */
  std::vector<float>
  points() const;

  /** A field at the points; vectors have three components. */
  std::vector<float>
  field(const std::string &name) const;

  std::vector<int>
  connectivity() const;

  double
  time() const;

  unsigned int n_points = 0, n_cells = 0;

private:
  /** Content of the first data array after `start`. */
  std::string
  array_text(const std::string &start) const;

  std::string content;
};

#endif
