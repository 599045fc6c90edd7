#include "app/window/previews.hpp"

#include "app/window/window_model.hpp"

namespace stemwise {
namespace {

using Shared = std::shared_ptr<const ui::Derived>;

/// Starts a job whose value goes to `place` in the status.
template <class Preview, class Work>
void start(WindowModel& m, std::optional<Preview> ui::WindowStatus::*place, Work work) {
  m.jobs.start<Preview>("Preview", JobLane::previews, [work = std::move(work)](const Progress&) { return work(); },
                        [&m, place](Preview preview) {
                          m.status.*place = std::move(preview);
                          return JobVerdict{};
                        });
}

}  // namespace

void Previews::forget() { *this = {}; }

void Previews::tend(WindowModel& m) {
  m.status.placement_busy = is_complete(m.view.placement) && (!m.status.placement || !(m.status.placement->form == m.view.placement) || m.status.placement->revision != m.document.revision());
  if (m.jobs.is_busy(JobLane::previews) || !m.document.is_derived() || m.document.derived().tables.inventories.empty()) return;
  if (m.view.step == ui::Step::merge) static_cast<void>(start_placement(m) || start_fusion(m));
  if (m.view.step == ui::Step::report) static_cast<void>(start_rules(m) || start_export(m) || start_report(m));
}

bool Previews::start_fusion(WindowModel& m) {
  if (fusion_of_ == m.document.revision()) return false;
  fusion_of_ = m.document.revision();
  start(m, &ui::WindowStatus::fusion, [state = m.document.snapshot(), derived = m.document.shared_derived(), revision = fusion_of_] {
    ui::FusionPreview preview{revision, {}};
    for (std::size_t i = 0; i < preview.policies.size(); ++i) preview.policies[i] = policy_effect(*state, derived->tables, static_cast<FusionPolicy>(i));
    return preview;
  });
  return true;
}

bool Previews::start_placement(WindowModel& m) {
  const std::pair key{m.document.revision(), m.view.placement};
  if (!is_complete(m.view.placement) || placement_of_ == key) return false;
  placement_of_ = key;
  start(m, &ui::WindowStatus::placement, [state = m.document.snapshot(), key] {
    ui::PlacementPreview preview = preview_placement(key.second, *state);
    preview.revision = key.first;
    return preview;
  });
  return true;
}

bool Previews::start_rules(WindowModel& m) {
  const std::string own = own_rules ? own_rules->name : "";
  if (rules_of_ == m.document.revision() && own_of_ == own) return false;
  rules_of_ = m.document.revision();
  own_of_ = own;
  std::vector<RulePack> packs = rule_packs();
  const std::optional<RulePack> chosen = chosen_rules(m.document.state());
  if (own_rules) packs.push_back(*own_rules);
  else if (chosen && find_rule_pack(chosen->name) == nullptr) packs.push_back(*chosen);
  start(m, &ui::WindowStatus::rules, [packs = std::move(packs), derived = m.document.shared_derived(), revision = rules_of_] {
    ui::RulePreviews previews{revision, {}};
    for (const RulePack& pack : packs) previews.packs.push_back({pack, count_broken(pack, derived->tables)});
    return previews;
  });
  return true;
}

bool Previews::start_export(WindowModel& m) {
  const std::pair key{m.document.revision(), m.view.exporting};
  if (export_of_ == key) return false;
  export_of_ = key;
  start(m, &ui::WindowStatus::exporting, [state = m.document.snapshot(), derived = m.document.shared_derived(), key] {
    ui::ExportPreview preview = preview_export(key.second, *state, derived->tables);
    preview.revision = key.first;
    return preview;
  });
  return true;
}

bool Previews::start_report(WindowModel& m) {
  const std::pair key{m.document.revision(), m.view.report_area_ha};
  if (report_of_ == key) return false;
  report_of_ = key;
  start(m, &ui::WindowStatus::reporting, [state = m.document.snapshot(), derived = m.document.shared_derived(), key] {
    ui::ReportPreview preview = preview_report(key.second, *state, derived->tables);
    preview.revision = key.first;
    return preview;
  });
  return true;
}

}  // namespace stemwise
