#ifndef asperity_base_ranks_h
#define asperity_base_ranks_h

#include <asperity/base/errors.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace asperity
{
  /** A failure that all ranks of a run have found together: one of them says
   *  it, and none has to end the others. */
  class SharedError : public ComputationError
  {
  public:
    using ComputationError::ComputationError;
  };

  /**
   * The processes that compute one scene together, all of which call the
   * members that are collective at the same time. After each of them every
   * process holds the same bits, so that all take the same decisions. A process
   * alone needs no MPI, and collective members leave it what it has.
   */
  class Ranks
  {
  public:
    /** This process alone, also under mpirun. */
    Ranks() = default;

    /** All that mpirun has started. */
    static Ranks
    together();

    unsigned int
    rank() const
    {
      return rank_;
    }

    unsigned int
    size() const
    {
      return size_;
    }

    bool
    are_several() const
    {
      return size_ > 1;
    }

    bool
    is_first() const
    {
      return rank_ == 0;
    }

    /** Collective: each number becomes its sum over the ranks, added up in one
     *  place. */
    void
    sum(double *values, const std::size_t n) const;

    /** Collective: the largest. */
    double
    largest(const double value) const;

    /** Collective: whether the condition holds on every rank. */
    bool
    all(const bool condition) const;

    /** Collective: the bytes of all ranks, in their order, on the first one;
     *  nothing on the others. */
    std::vector<std::string>
    gather(std::string own) const;

    /** Collective: waits for all others. */
    void
    meet() const;

    /**
     * Collective: gives everybody the blocks of an array of which each belongs
     * to one rank.
     * @param owner rank of each block
     * @param values block after block, all of one length, made of numbers
     *   alone; those of other ranks are overwritten
     */
    template <typename T>
    void
    share(const std::vector<unsigned int> &owner, std::vector<T> &values) const
    {
      static_assert(std::is_standard_layout_v<T>);
      if (are_several() && !owner.empty())
        share_bytes(owner,
                    values.size() / owner.size() * sizeof(T),
                    reinterpret_cast<char *>(values.data()));
    }

  private:
    void
    share_bytes(const std::vector<unsigned int> &owner,
                const std::size_t                block,
                char                            *values) const;

    unsigned int rank_ = 0, size_ = 1;
  };
} // namespace asperity

#endif
