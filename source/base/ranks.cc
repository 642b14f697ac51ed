#include <asperity/base/mpi_session.h>
#include <asperity/base/ranks.h>

#include <mpi.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace asperity
{
  Ranks
  Ranks::together()
  {
    Ranks ranks;
    ranks.size_ = MpiSession::n_ranks();
    if (ranks.size_ > 1)
      {
        int rank = 0;
        MPI_Comm_rank(MPI_COMM_WORLD, &rank);
        ranks.rank_ = rank;
      }
    return ranks;
  }



  void
  Ranks::sum(double *values, const std::size_t n) const
  {
    if (!are_several())
      return;
    // MPI only advises that all ranks get the same bits from MPI_Allreduce.
    const auto reduce_to_first = [&](double *from, double *to) {
      MPI_Reduce(from, to, n, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
    };
    if (is_first())
      reduce_to_first(static_cast<double *>(MPI_IN_PLACE), values);
    else
      reduce_to_first(values, nullptr);
    MPI_Bcast(values, n, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  }



  double
  Ranks::largest(double value) const
  {
    if (are_several())
      MPI_Allreduce(
        MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    return value;
  }



  bool
  Ranks::all(const bool condition) const
  {
    int result = condition;
    if (are_several())
      MPI_Allreduce(MPI_IN_PLACE, &result, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    return result != 0;
  }



  std::vector<std::string>
  Ranks::gather(std::string own) const
  {
    // Counts are integers of 32 bits: longer ones go in parts.
    constexpr std::size_t most = std::size_t(1) << 30;
    std::uint64_t         size = own.size();
    const auto            send = [&]() {
      MPI_Send(&size, 1, MPI_UINT64_T, 0, 0, MPI_COMM_WORLD);
      for (std::size_t i = 0; i < size; i += most)
        MPI_Send(own.data() + i,
                 std::min(most, own.size() - i),
                 MPI_BYTE,
                 0,
                 0,
                 MPI_COMM_WORLD);
    };
    const auto receive = [&](const int rank) {
      MPI_Recv(
        &size, 1, MPI_UINT64_T, rank, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      std::string bytes(size, '\0');
      for (std::size_t i = 0; i < size; i += most)
        MPI_Recv(bytes.data() + i,
                 std::min(most, bytes.size() - i),
                 MPI_BYTE,
                 rank,
                 0,
                 MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
      return bytes;
    };
    std::vector<std::string> all;
    if (!is_first())
      send();
    else
      all.push_back(std::move(own));
    for (unsigned int rank = 1; is_first() && rank < size_; ++rank)
      all.push_back(receive(rank));
    return all;
  }



  void
  Ranks::meet() const
  {
    if (are_several())
      MPI_Barrier(MPI_COMM_WORLD);
  }



  void
  Ranks::share_bytes(const std::vector<unsigned int> &owner,
                     const std::size_t                block,
                     char                            *values) const
  {
    std::vector<int> counts(size_, 0), first(size_, 0);
    for (const unsigned int rank : owner)
      ++counts[rank];
    std::partial_sum(counts.begin(), counts.end() - 1, first.begin() + 1);
    std::vector<char> own(counts[rank_] * block), all(owner.size() * block);
    char             *end = own.data();
    for (std::size_t i = 0; i < owner.size(); ++i)
      if (owner[i] == rank_)
        end = std::copy_n(values + i * block, block, end);
    // Counts are integers of 32 bits: they count blocks.
    MPI_Datatype type;
    MPI_Type_contiguous(block, MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Allgatherv(own.data(),
                   counts[rank_],
                   type,
                   all.data(),
                   counts.data(),
                   first.data(),
                   type,
                   MPI_COMM_WORLD);
    MPI_Type_free(&type);
    std::vector<std::size_t> next(first.begin(), first.end());
    for (std::size_t i = 0; i < owner.size(); ++i)
      std::copy_n(all.data() + block * next[owner[i]]++,
                  block,
                  values + i * block);
  }
} // namespace asperity
