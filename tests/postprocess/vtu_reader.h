#ifndef tests_postprocess_vtu_reader_h
#define tests_postprocess_vtu_reader_h

#include <string>
#include <vector>

/** What a visualisation program finds in a VTU file, of all its pieces. */
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

  unsigned int n_points = 0, n_cells = 0, n_pieces = 0;

private:
  std::string              head;
  std::vector<std::string> pieces;
};

#endif
