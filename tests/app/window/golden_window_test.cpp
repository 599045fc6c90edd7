#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/app/window/window_fixture.hpp"
#include "tests/render/golden.hpp"

namespace stemwise {
namespace {

/// Half as wide and high, each pixel the mean of four: what is compared is the look, not the edge of a letter.
render::Image halved(const render::Image& image) {
  render::Image small;
  small.size = {image.size.width / 2, image.size.height / 2};
  small.rgba.resize(static_cast<std::size_t>(small.size.width) * static_cast<std::size_t>(small.size.height) * 4);
  const auto width = static_cast<std::size_t>(image.size.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(small.size.height); ++y) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(small.size.width); ++x) {
      for (std::size_t c = 0; c < 4; ++c) {
        const std::size_t at = (2 * y * width + 2 * x) * 4 + c;
        const int sum = image.rgba[at] + image.rgba[at + 4] + image.rgba[at + 4 * width] + image.rgba[at + 4 * width + 4];
        small.rgba[(y * static_cast<std::size_t>(small.size.width) + x) * 4 + c] = static_cast<std::uint8_t>((sum + 2) / 4);
      }
    }
  }
  return small;
}

/// The whole window against tests/app/window/golden/NAME.png. STEMWISE_UPDATE_GOLDEN=1 writes it anew: look at it first.
class GoldenWindowTest : public WindowTest {
 protected:
  void expect_golden(const std::string& name) {
    const fs::path folder = fs::path(STEMWISE_SOURCE_DIR) / "tests" / "app" / "window" / "golden", seen = folder_ / (name + ".png");
    ASSERT_TRUE(window().screenshot(seen.string()));
    const auto full = render::read_png(seen.string());
    ASSERT_TRUE(full);
    const render::Image now = halved(*full);
    if (std::getenv("STEMWISE_UPDATE_GOLDEN") != nullptr) {
      fs::create_directories(folder);
      ASSERT_TRUE(render::write_png(now, (folder / (name + ".png")).string()));
      return;
    }
    const auto golden = render::read_png((folder / (name + ".png")).string());
    ASSERT_TRUE(golden) << name;
    const double share = test::difference(now, *golden);
    EXPECT_LT(share, 0.02) << name << ": see " << name << ".seen.png in the temporary folder";
    if (share >= 0.02) (void)render::write_png(now, (fs::temp_directory_path() / (name + ".seen.png")).string());
  }
  void look(ui::ThemeName theme, int width, int height) {
    model().view.theme = theme;
    window().resize(width, height);
    window().move_to(4, 4);
    window().settle();
  }
};

TEST_F(GoldenWindowTest, TheWindowLooksAsItDidInBothThemesAndTwoSizes) {
  look(ui::ThemeName::light, 1280, 720);
  expect_golden("empty-light-1280x720");
  window().press(ui::ActionId::file_demo);
  window().settle();
  align();
  window().press(ui::ActionId::step_review);
  window().press(ui::ActionId::review_next);
  window().settle();
  model().notices.clear();
  for (const auto theme : {ui::ThemeName::light, ui::ThemeName::dark}) {
    const std::string name = theme == ui::ThemeName::dark ? "dark" : "light";
    look(theme, 1280, 720);
    expect_golden("review-" + name + "-1280x720");
    look(theme, 1920, 1080);
    expect_golden("review-" + name + "-1920x1080");
  }
  look(ui::ThemeName::light, 1280, 720);
  window().press(ui::ActionId::step_align);
  window().settle();
  expect_golden("align-light-1280x720");
  window().press(ui::ActionId::step_merge);
  ASSERT_TRUE(window().click("tabs/Growth"));
  look(ui::ThemeName::dark, 1280, 720);
  expect_golden("merge-growth-dark-1280x720");
}

}  // namespace
}  // namespace stemwise
