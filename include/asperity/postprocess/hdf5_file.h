#ifndef asperity_postprocess_hdf5_file_h
#define asperity_postprocess_hdf5_file_h

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace asperity
{
  /** Numbers of an HDF5 file in rows and columns, row by row. */
  struct Hdf5Table
  {
    std::size_t         n_rows = 0, n_columns = 0;
    std::vector<double> values;
  };

  /**
   * The content of an HDF5 file as this program keeps data in them: named
   * tables of doubles and named texts, which h5dump, h5py or ParaView read.
   *
   * By the C functions of libhdf5, which deal.II links, since deal.II's own
   * classes of namespace HDF5 check what these functions return with
   * assertions, which a Release build does not have. Since libhdf5 may crash on
   * a damaged file, a checksum stands in the user block before HDF5's part, and
   * is compared before libhdf5 sees the file. Tables are compressed. Not for
   * several threads.
   */
  struct Hdf5Content
  {
    std::map<std::string, Hdf5Table>   tables;
    std::map<std::string, std::string> texts; ///< other names

    /** Atomically, see write_atomically(). @throws ComputationError if it
     * cannot be written */
    void
    write(const std::string &path) const;

    /**
     * Reads all of a file.
     * @param expected what messages say is expected, "fields of a run"
     * @throws InputError naming the file if it is missing, no such file, not
     *   complete, or damaged
     */
    static Hdf5Content
    read(const std::string &path, const std::string &expected);

    /** @throws InputError naming @p origin if there is none, or if it does not
     *  have this many numbers a row */
    const Hdf5Table &
    table(const std::string &name,
          const std::size_t  n_columns,
          const std::string &origin) const;

    /** @throws InputError naming @p origin if there is none */
    const std::string &
    text(const std::string &name, const std::string &origin) const;
  };
} // namespace asperity

#endif
