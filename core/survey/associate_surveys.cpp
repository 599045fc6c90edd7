#include "core/survey/associate_surveys.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "core/survey/match_stems.hpp"

namespace stemwise {
namespace {

constexpr double presence_per_miss = 0.5;  // a tree missed by a survey is half as likely to be in the next
constexpr int noise_rounds = 2;
constexpr int least_pairs_to_learn = 30;
constexpr double greatest_agreement = 0.98;  // two percent of all labels are wrong somewhere

using Partners = std::map<StemRef, std::vector<StemRef>>;

Partners partners_of(const std::vector<AlignHints::SameTree>& pairs) {
  Partners partners;
  for (const auto& p : pairs) partners[p.a].push_back(p.b), partners[p.b].push_back(p.a);
  return partners;
}

class Association {
 public:
  Association(std::span<const PlacedSurvey> surveys, const AlignHints& hints, double noise_floor_m)
      : surveys_(surveys), must_(partners_of(hints.same_tree)), must_not_(partners_of(hints.not_same)), noise_floor_m_(noise_floor_m), growth_cm_(surveys.size(), 0.0) {
    number_species();
    start_from(hints.base);
  }

  std::vector<SightedTree> run(const Progress& progress) {
    const std::size_t count = surveys_.size();
    const double steps = count > 2 ? 2.0 * static_cast<double>(count) : static_cast<double>(count);
    for (std::size_t k = 0; k < count; ++k) {
      if (fixed_[k] != 0) continue;
      progress.at(static_cast<double>(k) / steps, "Matching " + surveys_[k].inventory->name);
      join(k);
    }
    for (std::size_t k = 0; count > 2 && k < count; ++k) {
      if (fixed_[k] != 0) continue;
      progress.at(static_cast<double>(count + k) / steps, "Matching " + surveys_[k].inventory->name + " again");
      take_out(k);
      join(k);
    }
    return std::move(trees_);
  }

 private:
  StemRef ref(std::size_t survey, std::size_t node) const {
    return {surveys_[survey].inventory->id, static_cast<std::int64_t>(surveys_[survey].stem_of[node])};
  }
  /// Trees of the base, and how the stand grew between its surveys.
  void start_from(const AlignBase& base) {
    std::map<InventoryId, std::size_t> survey_of;
    for (std::size_t k = 0; k < surveys_.size(); ++k)
      for (const InventoryAlignment& pose : base.poses)
        if (pose.inventory == surveys_[k].inventory->id) survey_of[pose.inventory] = k, fixed_[k] = joined_[k] = 1;
    std::map<StemRef, std::size_t> node_of;
    for (const auto& [id, k] : survey_of)
      for (std::size_t node = 0; node < surveys_[k].list.size(); ++node) node_of[ref(k, node)] = node;
    for (const std::vector<StemRef>& stems : base.trees) {
      SightedTree tree;
      for (const StemRef& stem : stems)
        if (const auto found = node_of.find(stem); found != node_of.end()) tree.push_back({survey_of[stem.inventory], found->second, 1.0, false, {}, 0.0});
      std::sort(tree.begin(), tree.end(), [](const StemSighting& p, const StemSighting& q) { return p.survey < q.survey; });
      if (!tree.empty()) trees_.push_back(std::move(tree));
    }
    learn_growth();
  }

  /// Of the base: each survey against the one before it, by the median of the trees that both have.
  void learn_growth() {
    for (std::size_t k = 1; k < surveys_.size(); ++k) {
      std::vector<double> change_cm;
      for (const SightedTree& tree : trees_)
        for (std::size_t i = 1; i < tree.size(); ++i)
          if (tree[i].survey == k && dbh_cm(tree[i]) > 0.0 && dbh_cm(tree[i - 1]) > 0.0)
            change_cm.push_back(dbh_cm(tree[i]) - dbh_cm(tree[i - 1]) - (growth_cm_[k - 1] - growth_cm_[tree[i - 1].survey]));
      growth_cm_[k] = growth_cm_[k - 1];  // a new survey in between: its step counts with the next one's
      if (change_cm.size() < 8) continue;
      const auto middle = change_cm.begin() + static_cast<std::ptrdiff_t>(change_cm.size() / 2);
      std::nth_element(change_cm.begin(), middle, change_cm.end());
      growth_cm_[k] += *middle;
    }
  }

  void number_species() {
    std::map<std::string, int> number_of;
    for (const PlacedSurvey& survey : surveys_) {
      std::vector<int>& numbers = species_.emplace_back();
      for (const std::size_t stem : survey.stem_of) {
        std::string name = survey.inventory->stems[stem].species;
        for (char& c : name)
          if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        numbers.push_back(name.empty() ? -1 : number_of.try_emplace(name, static_cast<int>(number_of.size())).first->second);
      }
    }
  }

  /// The species that the tree's latest sighting with one gives it.
  int species_of(const SightedTree& tree) const {
    int species = -1;
    for (const StemSighting& s : tree)
      if (species_[s.survey][s.node] >= 0) species = species_[s.survey][s.node];
    return species;
  }

  const Eigen::Vector2d& place(const StemSighting& s) const { return surveys_[s.survey].list.nodes.at_m[s.node]; }
  double dbh_cm(const StemSighting& s) const { return surveys_[s.survey].list.nodes.dbh_cm[s.node]; }

  /// DBH at survey k: of the nearest sightings before and after, moved by the stand's growth between.
  double expected_dbh_cm(const SightedTree& tree, std::size_t k) const {
    double before = -1.0, after = -1.0;
    for (const StemSighting& s : tree) {
      if (dbh_cm(s) <= 0.0) continue;
      const double then = std::max(1.0, dbh_cm(s) + growth_cm_[k] - growth_cm_[s.survey]);
      if (s.survey < k) before = then;
      if (s.survey > k && after < 0.0) after = then;
    }
    return before > 0.0 && after > 0.0 ? 0.5 * (before + after) : std::max(before, after);
  }

  /// How much less likely the tree is in survey k for having been missed next to it in time.
  double presence_factor(const SightedTree& tree, const Eigen::Vector2d& at, std::size_t k) const {
    int misses = 1000;
    const auto count_between = [&](std::size_t from, std::size_t to) {
      int missed = 0;
      for (std::size_t m = from + 1; m < to; ++m) missed += surveys_[m].list.support.contains(at) ? 1 : 0;
      return missed;
    };
    bool before = false, after = false;
    for (const StemSighting& s : tree) {
      misses = std::min(misses, s.survey < k ? count_between(s.survey, k) : count_between(k, s.survey));
      before = before || s.survey < k, after = after || s.survey > k;
    }
    return before && after ? 1.0 : std::pow(presence_per_miss, misses);
  }

  Eigen::Vector2d mean_place(const SightedTree& tree) const {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const StemSighting& s : tree) sum += place(s);
    return sum / static_cast<double>(tree.size());
  }

  IndexedList tree_list(std::size_t k) const {
    NodeList nodes;
    for (std::size_t t = 0; t < trees_.size(); ++t) {
      nodes.at_m.push_back(mean_place(trees_[t]));
      nodes.dbh_cm.push_back(expected_dbh_cm(trees_[t], k));
    }
    nodes.members.resize(nodes.size());
    return IndexedList(std::move(nodes));
  }

  std::size_t tree_with(const StemRef& stem) const {
    for (std::size_t t = 0; t < trees_.size(); ++t)
      for (const StemSighting& s : trees_[t])
        if (ref(s.survey, s.node) == stem) return t;
    return trees_.size();
  }

  /// Two trees that a person says are one become one, if no survey has both.
  void merge_linked(std::size_t k) {
    if (must_.empty()) return;
    for (std::size_t node = 0; node < surveys_[k].list.size(); ++node) {
      const auto found = must_.find(ref(k, node));
      if (found == must_.end()) continue;
      std::size_t first = trees_.size();
      for (const StemRef& partner : found->second) {
        const std::size_t t = tree_with(partner);
        if (t == trees_.size() || t == first) continue;
        if (first == trees_.size()) first = t;
        else merge(first, t);
        first = std::min(first, trees_.size() - 1);
      }
    }
  }

  void merge(std::size_t& keep, std::size_t other) {
    for (const StemSighting& s : trees_[other])
      for (const StemSighting& r : trees_[keep])
        if (s.survey == r.survey) return;
    trees_[keep].insert(trees_[keep].end(), trees_[other].begin(), trees_[other].end());
    std::sort(trees_[keep].begin(), trees_[keep].end(), [](const StemSighting& p, const StemSighting& q) { return p.survey < q.survey; });
    trees_.erase(trees_.begin() + static_cast<std::ptrdiff_t>(other));
    if (other < keep) --keep;
  }

  MatchConstraints constraints(std::size_t k) const {
    MatchConstraints result;
    if (must_.empty() && must_not_.empty()) return result;
    std::map<StemRef, std::size_t> tree_of;
    for (std::size_t t = 0; t < trees_.size(); ++t)
      for (const StemSighting& s : trees_[t]) tree_of[ref(s.survey, s.node)] = t;
    const auto add = [&](const Partners& partners, std::size_t node, std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
      const auto found = partners.find(ref(k, node));
      if (found == partners.end()) return;
      for (const StemRef& partner : found->second)
        if (const auto tree = tree_of.find(partner); tree != tree_of.end()) pairs.emplace_back(tree->second, node);
    };
    for (std::size_t node = 0; node < surveys_[k].list.size(); ++node) add(must_, node, result.must), add(must_not_, node, result.must_not);
    return result;
  }

  /// Noise and growth of this step, from matches that are sure.
  void refit(PoseFit& fit, const IndexedList& trees, const IndexedList& stems, const std::vector<StemMatch>& matches) const {
    std::vector<double> distance_sq;
    for (const StemMatch& m : matches)
      if (m.confidence > 0.9) distance_sq.push_back((trees.nodes.at_m[m.a] - stems.nodes.at_m[m.b]).squaredNorm());
    if (distance_sq.size() < 8) return;
    const auto middle = distance_sq.begin() + static_cast<std::ptrdiff_t>(distance_sq.size() / 2);
    std::nth_element(distance_sq.begin(), middle, distance_sq.end());
    fit.noise_m = std::max(noise_floor_m_, std::sqrt(*middle / 1.386));  // median of r^2 is 2 ln 2 sigma^2
  }

  /// The share of sure matches whose DBH nothing but a gross error explains. Where there are hardly any, a small stem in the
  /// place of a large one is another tree.
  static double gross_share(const DbhModel& model, const IndexedList& trees, const IndexedList& stems, const std::vector<StemMatch>& matches) {
    constexpr double beyond_sd = 6.0, least = 0.002, greatest = 0.03;
    double both = 0.0, gross = 0.0;
    for (const StemMatch& m : matches) {
      const double a_cm = trees.nodes.dbh_cm[m.a], b_cm = stems.nodes.dbh_cm[m.b];
      if (m.confidence <= 0.9 || a_cm <= 0.0 || b_cm <= 0.0) continue;
      both += 1.0;
      gross += std::abs(b_cm - a_cm - model.growth_cm) > beyond_sd * dbh_sd_cm(model, a_cm) ? 1.0 : 0.0;
    }
    return both < least_pairs_to_learn ? greatest : std::clamp(gross / both, least, greatest);
  }

  /// How often labels of sure matches agree, against how often any two labels of both lists do. Lists that name species each
  /// in its own way (codes, languages) agree no more than chance: then nothing is said.
  void learn_species(SpeciesEvidence& evidence, const std::vector<StemMatch>& matches) const {
    double both = 0.0, agree = 0.0;
    for (const StemMatch& m : matches) {
      if (m.confidence <= 0.9 || evidence.of_a[m.a] < 0 || evidence.of_b[m.b] < 0) continue;
      both += 1.0;
      agree += evidence.of_a[m.a] == evidence.of_b[m.b] ? 1.0 : 0.0;
    }
    evidence.same = evidence.other = 0.0;
    if (both < least_pairs_to_learn) return;
    const double chance = std::clamp(chance_agreement(evidence), 0.01, 0.99), share = std::min(greatest_agreement, agree / both);
    if (share <= chance + 0.1) return;
    evidence.same = std::log(share / chance);
    evidence.other = std::log((1.0 - share) / (1.0 - chance));
  }

  static double chance_agreement(const SpeciesEvidence& evidence) {
    std::map<int, std::pair<double, double>> counts;
    double all_a = 0.0, all_b = 0.0, same = 0.0;
    for (const int s : evidence.of_a)
      if (s >= 0) counts[s].first += 1.0, all_a += 1.0;
    for (const int s : evidence.of_b)
      if (s >= 0) counts[s].second += 1.0, all_b += 1.0;
    for (const auto& [species, count] : counts) same += count.first * count.second;
    return same / std::max(1.0, all_a * all_b);
  }

  void join(std::size_t k) {
    merge_linked(k);
    const IndexedList trees = tree_list(k);
    const IndexedList& stems = surveys_[k].list;
    if (trees.size() == 0) return start_trees(k, {});
    std::vector<std::size_t> all(trees.size());
    std::iota(all.begin(), all.end(), 0);
    PoseFit fit{{}, surveys_[k].noise_m, {true, 0.0, 1.0}, 0.0};
    std::vector<StemMatch> matches;
    const MatchConstraints fixed = constraints(k);
    MatchPriors priors;
    priors.species.of_b = species_[k];
    for (const SightedTree& tree : trees_) priors.species.of_a.push_back(species_of(tree));
    for (int round = 0; round <= noise_rounds; ++round) {
      fit.dbh = refit_dbh(trees, all, stems, fit);
      if (round > 0) fit.dbh.gross = gross_share(fit.dbh, trees, stems, matches);
      const PoseScore score = score_pose(trees, stems, fit, nullptr);
      priors.share_a = score.share_a, priors.share_b = score.share_b;
      priors.presence_a.clear();
      for (std::size_t t = 0; t < trees_.size(); ++t) priors.presence_a.push_back(score.share_b * presence_factor(trees_[t], trees.nodes.at_m[t], k));
      matches = match_stems(trees, stems, fit, priors, fixed);
      refit(fit, trees, stems, matches);
      learn_species(priors.species, matches);
    }
    if (joined_[k] == 0) grow_by(k, fit.dbh.growth_cm);
    joined_[k] = 1;
    attach(k, matches, trees);
  }

  /// The stand's DBH at k and after is larger by what this step found beyond what was expected. What a base knows stays.
  void grow_by(std::size_t k, double growth_cm) {
    const bool based = std::find(fixed_.begin(), fixed_.end(), 1) != fixed_.end();
    for (std::size_t m = k; m < (based ? k + 1 : growth_cm_.size()); ++m) growth_cm_[m] += growth_cm;
  }

  void attach(std::size_t k, const std::vector<StemMatch>& matches, const IndexedList& trees) {
    const IndexedList& stems = surveys_[k].list;
    std::vector<std::uint8_t> taken(stems.size(), 0);
    std::vector<std::pair<std::size_t, StemSighting>> joined;
    for (const StemMatch& m : matches) {
      StemSighting s{k, m.b, m.confidence, m.by_hand, {}, 0.0};
      if (m.second_b) {
        s.second_choice = ref(k, *m.second_b);
        s.second_distance_m = (trees.nodes.at_m[m.a] - stems.nodes.at_m[*m.second_b]).norm();
      } else if (m.second_a) {
        const StemSighting& other = trees_[*m.second_a].back();
        s.second_choice = ref(other.survey, other.node);
        s.second_distance_m = (trees.nodes.at_m[*m.second_a] - stems.nodes.at_m[m.b]).norm();
      }
      taken[m.b] = 1;
      joined.emplace_back(m.a, s);
    }
    for (const auto& [tree, sighting] : joined) {
      auto& list = trees_[tree];
      list.insert(std::find_if(list.begin(), list.end(), [&](const StemSighting& o) { return o.survey > k; }), sighting);
    }
    start_trees(k, taken);
  }

  void start_trees(std::size_t k, const std::vector<std::uint8_t>& taken) {
    for (std::size_t node = 0; node < surveys_[k].list.size(); ++node)
      if (taken.empty() || taken[node] == 0) trees_.push_back({StemSighting{k, node, 1.0, false, {}, 0.0}});
    joined_[k] = 1;
  }

  void take_out(std::size_t k) {
    for (auto& tree : trees_) std::erase_if(tree, [k](const StemSighting& s) { return s.survey == k; });
    std::erase_if(trees_, [](const SightedTree& tree) { return tree.empty(); });
  }

  std::span<const PlacedSurvey> surveys_;
  Partners must_, must_not_;
  double noise_floor_m_;
  std::vector<double> growth_cm_;  ///< of the stand since the first survey
  std::vector<std::uint8_t> fixed_ = std::vector<std::uint8_t>(surveys_.size(), 0);  ///< of the base
  std::vector<std::uint8_t> joined_ = std::vector<std::uint8_t>(surveys_.size(), 0);
  std::vector<std::vector<int>> species_;  ///< per survey and node, as numbers; -1: not known
  std::vector<SightedTree> trees_;
};

}  // namespace

std::vector<SightedTree> associate_surveys(std::span<const PlacedSurvey> surveys, const AlignHints& hints, double noise_floor_m, const Progress& progress) {
  return Association(surveys, hints, noise_floor_m).run(progress);
}

std::vector<Match> consecutive_matches(std::span<const PlacedSurvey> surveys, const std::vector<SightedTree>& trees) {
  std::vector<Match> matches;
  const auto ref = [&](const StemSighting& s) { return StemRef{surveys[s.survey].inventory->id, static_cast<std::int64_t>(surveys[s.survey].stem_of[s.node])}; };
  const auto place = [&](const StemSighting& s) { return surveys[s.survey].list.nodes.at_m[s.node]; };
  for (const SightedTree& tree : trees)
    for (std::size_t i = 1; i < tree.size(); ++i) {
      const StemSighting &before = tree[i - 1], &after = tree[i];
      const StemSighting& doubtful = before.confidence < after.confidence ? before : after;
      Match match{ref(before), ref(after), (place(before) - place(after)).norm(), doubtful.confidence, MatchState::automatic, {}, {}};
      if (before.by_hand || after.by_hand) match.state = MatchState::linked;
      if (doubtful.second_choice) match.second_choice = doubtful.second_choice, match.second_distance_m = doubtful.second_distance_m;
      matches.push_back(match);
    }
  std::sort(matches.begin(), matches.end(), [](const Match& p, const Match& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
  return matches;
}

}  // namespace stemwise
