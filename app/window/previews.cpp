#include "app/window/previews.hpp"

#include <algorithm>

#include "app/window/window_model.hpp"

namespace stemwise {
namespace {

/// Starts a job whose value goes to `place` in the status.
template <class Preview, class Work>
void start(WindowModel& m, std::optional<Preview> ui::WindowStatus::*place, Work work) {
  m.jobs.start<Preview>("Preview", JobLane::previews, [work = std::move(work)](const Progress&) { return work(); },
                        [&m, place](Preview preview) {
                          m.status.*place = std::move(preview);
                          return JobVerdict{};
                        });
}

/// The same pages, whichever of them is looked at and how large.
bool are_same_pages(ui::PageForm a, const ui::PageForm& b) {
  a.page = b.page;
  a.width_px = b.width_px;
  return a == b;
}

}  // namespace

void Previews::forget() {
  own_rules.reset();
  asked_ = {};
  pages_.reset();
}

void Previews::tend(WindowModel& m) {
  m.status.placement_busy = is_complete(m.view.placement) && (!m.status.placement || !(m.status.placement->form == m.view.placement) || m.status.placement->revision != m.document.revision());
  if (m.jobs.is_busy(JobLane::previews) || !m.document.is_derived() || m.document.derived().tables.inventories.empty()) return;
  if (m.view.dialog == ui::Dialog::pages && start_page(m)) return;
  if (m.view.step == ui::Step::merge) static_cast<void>(start_placement(m) || start_fusion(m));
  if (m.view.step == ui::Step::report) static_cast<void>(start_rules(m) || start_export(m) || start_report(m));
}

bool Previews::start_fusion(WindowModel& m) {
  if (asked_.fusion == m.document.revision()) return false;
  asked_.fusion = m.document.revision();
  start(m, &ui::WindowStatus::fusion, [state = m.document.snapshot(), derived = m.document.shared_derived(), revision = asked_.fusion] {
    ui::FusionPreview preview{revision, {}};
    for (std::size_t i = 0; i < preview.policies.size(); ++i) preview.policies[i] = policy_effect(*state, derived->tables, static_cast<FusionPolicy>(i));
    return preview;
  });
  return true;
}

bool Previews::start_placement(WindowModel& m) {
  const std::pair key{m.document.revision(), m.view.placement};
  if (!is_complete(m.view.placement) || asked_.placement == key) return false;
  asked_.placement = key;
  start(m, &ui::WindowStatus::placement, [state = m.document.snapshot(), key] {
    ui::PlacementPreview preview = preview_placement(key.second, *state);
    preview.revision = key.first;
    return preview;
  });
  return true;
}

bool Previews::start_rules(WindowModel& m) {
  const std::string own = own_rules ? own_rules->name : "";
  if (asked_.rules == m.document.revision() && asked_.own_rules == own) return false;
  asked_.rules = m.document.revision();
  asked_.own_rules = own;
  std::vector<RulePack> packs = rule_packs();
  const std::optional<RulePack> chosen = chosen_rules(m.document.state());
  if (own_rules) packs.push_back(*own_rules);
  else if (chosen && find_rule_pack(chosen->name) == nullptr) packs.push_back(*chosen);
  start(m, &ui::WindowStatus::rules, [packs = std::move(packs), derived = m.document.shared_derived(), revision = asked_.rules] {
    ui::RulePreviews previews{revision, {}};
    for (const RulePack& pack : packs) previews.packs.push_back({pack, count_broken(pack, derived->tables)});
    return previews;
  });
  return true;
}

bool Previews::start_export(WindowModel& m) {
  const std::pair key{m.document.revision(), m.view.exporting};
  if (asked_.exporting == key) return false;
  asked_.exporting = key;
  start(m, &ui::WindowStatus::exporting, [state = m.document.snapshot(), derived = m.document.shared_derived(), key] {
    ui::ExportPreview preview = preview_export(key.second, *state, derived->tables);
    preview.revision = key.first;
    return preview;
  });
  return true;
}

bool Previews::start_report(WindowModel& m) {
  const std::pair key{m.document.revision(), m.view.report_area_ha};
  if (asked_.report == key) return false;
  asked_.report = key;
  start(m, &ui::WindowStatus::reporting, [state = m.document.snapshot(), derived = m.document.shared_derived(), key] {
    ui::ReportPreview preview = preview_report(key.second, *state, derived->tables);
    preview.revision = key.first;
    return preview;
  });
  return true;
}

bool Previews::start_page(WindowModel& m) {
  const ui::PageForm& form = m.view.page;
  const std::uint64_t revision = m.document.revision();
  if (form.width_px < 40 || (asked_.page.first == revision && asked_.page.second == form)) return false;
  if (asked_.page.first != revision || !are_same_pages(asked_.page.second, form)) pages_.reset();
  asked_.page = {revision, form};
  struct Drawn {
    std::shared_ptr<const RecordedPages> pages;
    PagePicture picture;
  };
  m.jobs.start<Drawn>(
      "Preview", JobLane::previews,
      [form, pages = pages_, state = m.document.snapshot(), derived = m.document.shared_derived()](const Progress&) {
        Drawn drawn{pages, {}};
        if (!drawn.pages) drawn.pages = std::make_shared<const RecordedPages>(preview_pages(form, *state, derived->tables));
        if (form.page < drawn.pages->count()) drawn.picture = drawn.pages->picture(form.page, form.width_px);
        return drawn;
      },
      [this, &m, form, revision](Drawn drawn) {
        pages_ = std::move(drawn.pages);
        show_page(m, form, revision, drawn.picture);
        return JobVerdict{};
      });
  return true;
}

void Previews::show_page(WindowModel& m, const ui::PageForm& form, std::uint64_t revision, const PagePicture& picture) {
  const int pages = pages_->count();
  m.view.page.page = std::clamp(m.view.page.page, 0, std::max(0, pages - 1));
  if (picture.rgba.empty()) return;  // fewer pages than before: the last one is asked for in the next frame
  page_.upload(picture.rgba.data(), picture.width_px, picture.height_px);
  m.status.page = ui::PageView{form, revision, pages, page_.id(), page_.width_px(), page_.height_px()};
  ++pages_shown_;
}

}  // namespace stemwise
