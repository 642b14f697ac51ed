#ifndef asperity_learning_t_sne_h
#define asperity_learning_t_sne_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asperity
{
  /** Settings of t-SNE as its authors give them. */
  struct EmbeddingOptions
  {
    double       perplexity    = 30.; ///< neighbours that a point is drawn to
    unsigned int n_steps       = 1000;
    double       rate          = 100.;
    double       exaggeration  = 4.; ///< of the probabilities at first
    unsigned int n_exaggerated = 50; ///< steps

    std::uint64_t seed = 1;
  };

  /**
   * The probabilities p_ij = (p_j|i + p_i|j) / 2n that i and j are neighbours,
   * p_j|i being normal in their distance, with the width for which its entropy
   * is the logarithm of the perplexity.
   * @param points coordinates of point after point
   * @return n x n numbers that sum up to 1
   * @throws InputError if there are not more than three times as many points as
   *   the perplexity, or it is below 1
   */
  std::vector<double>
  neighbour_probabilities(const std::vector<double> &points,
                          const unsigned int         n_coordinates,
                          const double               perplexity);

  /**
   * The Kullback-Leibler divergence sum p_ij log(p_ij / q_ij) of points in the
   * plane, q_ij = w_ij / sum w_kl, w_ij = 1 / (1 + |y_i - y_j|^2).
   * @param places x and y of point after point
   * @param gradient if given: as long as the places
   */
  double
  embedding_divergence(const std::vector<double> &probabilities,
                       const std::vector<double> &places,
                       std::vector<double>       *gradient = nullptr);

  /**
   * Places in the plane for points of many coordinates, so that neighbours stay
   * neighbours: t-SNE, exact (van der Maaten and Hinton 2008). n^2 operations a
   * step: a minute for 2659 points.
   * @return x and y of point after point
   * @throws InputError as neighbour_probabilities()
   */
  std::vector<double>
  embed_in_plane(const std::vector<double> &points,
                 const unsigned int         n_coordinates,
                 const EmbeddingOptions    &options = EmbeddingOptions());
} // namespace asperity

#endif
