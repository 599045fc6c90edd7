#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/jobs/progress.hpp"
#include "core/treeloc/pose_covariance.hpp"
#include "core/treeloc/scene.hpp"
#include "core/treeloc/settings.hpp"

namespace stemwise::treeloc {

/// One scene of the database against the query, verified.
struct Candidate {
  std::uint32_t scene = 0;              ///< index in the database
  double score = 0.0;                   ///< overlap score of the method (eq. 12, or the default method's form)
  int pairs = 0;                        ///< matched trees |M|
  int votes = 0;                        ///< what retrieval gave it; 0 when it was proposed by a neighbour's pose
  double evidence = 0.0;                ///< chance_evidence: above 0 the pairs are not chance (of the chosen one only)
  double displacement_m = 0.0;          ///< planar |t|
  RigidTransform candidate_from_query;  ///< all six degrees of freedom, in the scenes' own (not aligned) frames
};

/// The answer to one query.
struct Localization {
  std::vector<Candidate> candidates;  ///< verified ones, the chosen one first, the others by score
  PoseCovariance covariance = PoseCovariance::Zero();  ///< of the chosen one's pose
  int triangles = 0;
  double describe_s = 0.0, retrieve_s = 0.0, verify_s = 0.0;
};

/// Localises queries; keeps buffers between them, so there is one per thread. The answer does not depend on what was asked
/// before.
class QueryWorker {
public:
  static constexpr std::uint32_t all_scenes = std::numeric_limits<std::uint32_t>::max();
  QueryWorker() = default;
  QueryWorker(const QueryWorker&) = delete;
  QueryWorker& operator=(const QueryWorker&) = delete;
  virtual ~QueryWorker() = default;
  /// Only the scenes below `scene_limit` are candidates.
  virtual Localization localize(const Scene& query, std::uint32_t scene_limit) = 0;
};

struct IndexSegment;

/// Scenes for a database, and what describing them gave where that was done already (the default method's triangles).
struct DescribedScenes {
  DescribedScenes(std::vector<Scene> of) : scenes(std::move(of)) {}
  DescribedScenes(std::vector<Scene> of, std::shared_ptr<IndexSegment> index) : scenes(std::move(of)), triangles(std::move(index)) {}
  std::vector<Scene> scenes;
  std::shared_ptr<IndexSegment> triangles;  ///< by `index_scenes` with the method's settings; taken out by who adds it
};

/// A database of scenes of one survey, and a method to find where a query lies in it.
class Localizer {
public:
  Localizer() = default;
  Localizer(const Localizer&) = delete;
  Localizer& operator=(const Localizer&) = delete;
  virtual ~Localizer() = default;
  /// Describes scenes, where they are not, and adds them behind those already there.
  virtual void add(DescribedScenes described, int threads) = 0;
  virtual const std::vector<Scene>& scenes() const = 0;
  /// Lives no longer than the localizer; adding scenes ends its use.
  virtual std::unique_ptr<QueryWorker> worker() const = 0;
};

std::unique_ptr<Localizer> make_localizer(const Settings& settings);

/// Localises many queries over threads; the result does not depend on how many. Throws Cancelled. `scene_limits` is empty or has
/// one per query.
std::vector<Localization> localize_all(const Localizer& localizer, std::span<const Scene> queries,
                                       std::span<const std::uint32_t> scene_limits, int threads, const Progress& progress);

}  // namespace stemwise::treeloc
