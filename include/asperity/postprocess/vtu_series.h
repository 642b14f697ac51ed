#ifndef asperity_postprocess_vtu_series_h
#define asperity_postprocess_vtu_series_h

#include <functional>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace asperity
{
  /**
   * The pictures of one part of the scene over time: files
   * `<name>_<step, six digits>.vtu` and the record `<name>.pvd` that gives each
   * its physical time. The record is rewritten after every file, so what it
   * names exists.
   */
  class VtuSeries
  {
  public:
    static constexpr int keep_nothing = -1;

    /**
     * @param directory output directory
     * @param name part of the scene, "chip"
     * @param keep_until_step on a restart: files of steps up to this one stay
     * in the record. Files of this series and of later steps are deleted (all
     * of them if nothing is kept), lest pictures of two runs be mixed.
     */
    VtuSeries(const std::string &directory,
              const std::string &name,
              const int          keep_until_step = keep_nothing);

    /**
     * @param write fills the file, as write_polyline() and ChipOutput::write()
     * do
     * @throws ComputationError if the file cannot be written, and what `write`
     *   throws; the record then stays as it was
     */
    void
    write(const unsigned int                         step,
          const double                               time,
          const std::function<void(std::ostream &)> &write);

    /** Path of the file of a step. */
    std::string
    path(const unsigned int step) const;

  private:
    void
    read_record(const int keep_until_step);

    void
    remove_files(const int keep_until_step) const;

    void
    write_record() const;

    std::string
    file_name(const unsigned int step) const;

    std::string                                 directory, name;
    std::vector<std::pair<double, std::string>> record;
  };
} // namespace asperity

#endif
