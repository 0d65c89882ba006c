#include "plan/drawn_openings.h"
#include "plan/plan_drawing.h"
#include "plan/plan_raster.h"
#include "plan/plan_style.h"
#include "plan/stroke_font.h"
#include "plan/text_places.h"
#include "plan/unseen_borders.h"
#include "plan/wall_bodies.h"
#include <pcl/core/impl/planar_geometry.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl::acmap::test {
namespace {

using Eigen::Vector2d;
using testing::Contains;
using testing::ElementsAre;
using testing::Not;

constexpr double strip = 0.08; // metres

void
addWalls(const std::vector<Vector2d>& corners, FloorPlan& plan)
{
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    plan.walls.push_back({corners[k], corners[k + 1], plan.walls.size()});
}

/** Rooms of 4 x 3 m and 2 x 3 m with a wall of 0.1 m between them, a door of 0.9 x 2 m in it,
 * and a window of 1.2 x 1 m in the far wall of the larger one. */
FloorPlan
planOfTwoRooms()
{
  FloorPlan plan;
  addWalls({{4, 1.9}, {4, 3}, {2.2, 3}}, plan);
  addWalls({{1, 3}, {0, 3}, {0, 0}, {4, 0}, {4, 1}}, plan);
  addWalls({{4.1, 1}, {4.1, 0}, {6.1, 0}, {6.1, 3}, {4.1, 3}, {4.1, 1.9}}, plan);
  plan.openings = {{{4, 1}, {4, 1.9}, 4}, {{4.1, 1.9}, {4.1, 1}, 5}};
  plan.openings[0].rooms = {0, 1};
  plan.openings[1].rooms = {1, 0};
  plan.openings[0].top = plan.openings[1].top = 2;
  plan.openings.push_back({{2.2, 3}, {1, 3}, 1, true, 1, 2});
  plan.openings[2].rooms = {0, -1};
  plan.rooms.resize(2);
  plan.rooms[0].center = {2, 1.5};
  plan.rooms[0].area = plan.rooms[0].seen_area = 12;
  plan.rooms[0].outline = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  plan.rooms[1].center = {5.1, 1.5};
  plan.rooms[1].area = plan.rooms[1].seen_area = 6;
  plan.rooms[1].outline = {{4.1, 0}, {6.1, 0}, {6.1, 3}, {4.1, 3}};
  plan.rooms[1].name = "Kitchen & bath";
  for (const PlanRoom& room : plan.rooms)
    plan.floors.push_back({room.outline});
  plan.cut = 1.5;
  return plan;
}

/** The same, turned about the origin. */
FloorPlan
turned(FloorPlan plan, double angle)
{
  const Eigen::Rotation2Dd turn(angle);
  for (PlanWall& wall : plan.walls) {
    wall.from = turn * wall.from;
    wall.to = turn * wall.to;
  }
  for (PlanOpening& opening : plan.openings) {
    opening.from = turn * opening.from;
    opening.to = turn * opening.to;
  }
  for (PlanRoom& room : plan.rooms) {
    room.center = turn * room.center;
    for (Vector2d& corner : room.outline)
      corner = turn * corner;
  }
  for (auto& polygon : plan.floors)
    for (auto& loop : polygon)
      for (Vector2d& corner : loop)
        corner = turn * corner;
  return plan;
}

bool
isFilled(const std::vector<WallBody>& bodies, const Vector2d& place)
{
  return std::any_of(bodies.begin(), bodies.end(), [&](const WallBody& body) {
    return isInside(std::vector<Vector2d>(body.corners.begin(), body.corners.end()),
                    place);
  });
}

TEST(WallBodies, FillWhatIsBetweenBothFaces)
{
  const std::vector<WallBody> bodies = wallBodiesOf(planOfTwoRooms(), strip);
  std::size_t measured = 0;
  for (const WallBody& body : bodies)
    if (body.is_measured) {
      ++measured;
      for (const Vector2d& corner : body.corners)
        EXPECT_NEAR(corner.x(), 4.05, 0.05 + 1e-9);
    }
  EXPECT_EQ(measured, 4U) << "both faces, on both sides of the door";
  EXPECT_TRUE(isFilled(bodies, {4.05, 0.5}));
  EXPECT_TRUE(isFilled(bodies, {4.05, 2.5}));
  EXPECT_FALSE(isFilled(bodies, {4.05, 1.45})) << "the door";
  EXPECT_FALSE(isFilled(bodies, {1.6, 3.04})) << "the window";
  EXPECT_FALSE(isFilled(bodies, {2, 1}));
}

TEST(WallBodies, AreJoinedInCorners)
{
  const std::vector<WallBody> bodies = wallBodiesOf(planOfTwoRooms(), strip);
  for (const Vector2d& corner : {Vector2d(-0.07, -0.07),
                                 Vector2d(6.17, 3.07),
                                 Vector2d(4.05, -0.07), // behind the wall between them
                                 Vector2d(4.05, 3.07)})
    EXPECT_TRUE(isFilled(bodies, corner)) << corner.transpose();
  FloorPlan short_of_corner = planOfTwoRooms(); // as outlines may be
  for (PlanWall& wall : short_of_corner.walls)
    wall.to -= 0.05 * (wall.to - wall.from).normalized();
  EXPECT_TRUE(isFilled(wallBodiesOf(short_of_corner, strip), {6.17, 3.07}));
}

TEST(WallBodies, FurnitureIsNoWall)
{
  FloorPlan plan = planOfTwoRooms();
  for (PlanWall& wall : plan.walls)
    wall.role = SurfaceRole::Furniture;
  EXPECT_TRUE(wallBodiesOf(plan, strip).empty());
}

TEST(DrawnOpenings, AreOneForBothFaces)
{
  const FloorPlan plan = planOfTwoRooms();
  const auto openings = drawnOpeningsOf(plan, wallBodiesOf(plan, strip), strip);
  ASSERT_EQ(openings.size(), 2U);
  const DrawnOpening& door = openings[0];
  EXPECT_TRUE(door.is_measured);
  EXPECT_NEAR(door.depth, 0.1, 1e-9);
  EXPECT_NEAR(door.width(), 0.9, 1e-9);
  EXPECT_FALSE(door.opens_to_front) << "the room behind it is smaller";
  EXPECT_EQ(door.hinge, Vector2d(4, 1)) << "nearer to a corner";
  EXPECT_EQ(door.lock, Vector2d(4, 1.9));
  EXPECT_FALSE(openings[1].is_measured);
  EXPECT_EQ(openings[1].depth, strip);
}

TEST(DrawnOpenings, HaveTheDepthOfTheirRevealsAndTheSideOfTheirLeaf)
{
  FloorPlan plan = planOfTwoRooms();
  plan.openings = {plan.openings[0]};
  plan.openings[0].rooms = {0, -1};
  for (PlanWall& wall : plan.walls)
    if (wall.from.x() > 4.05 || wall.to.x() > 4.05)
      wall.role = SurfaceRole::Other; // the other room was not seen
  addWalls({{4.25, 1}, {4, 1}}, plan);
  const auto found = [&] {
    return drawnOpeningsOf(plan, wallBodiesOf(plan, strip), strip).at(0);
  };
  EXPECT_NEAR(found().depth, 0.25, 1e-9);
  EXPECT_TRUE(found().opens_to_front) << "nothing was seen behind it";
  plan.openings[0].leaf = 0.2;
  EXPECT_FALSE(found().opens_to_front);
}

/** The texts of a drawing. */
std::vector<PlanText>
textsOf(const PlanDrawing& drawing)
{
  std::vector<PlanText> texts;
  for (const PlanItem& item : drawing.items)
    if (const auto* text = std::get_if<PlanText>(&item.shape))
      texts.push_back(*text);
  return texts;
}

std::vector<std::string>
wordsOf(const PlanDrawing& drawing)
{
  std::vector<std::string> words;
  for (const PlanText& text : textsOf(drawing))
    words.push_back(text.text);
  return words;
}

TEST(PlanDrawing, NamesRoomsAndDimensions)
{
  for (const double angle : {0.0, 0.3}) {
    const PlanDrawing drawing = drawPlan(turned(planOfTwoRooms(), angle));
    const std::vector<std::string> words = wordsOf(drawing);
    for (const char* text : {"Room 1",
                             "Kitchen & bath",
                             "12.0 m\u00B2",
                             "6.0 m\u00B2",
                             "0.90 \u00D7 2.00",
                             "1.20 \u00D7 1.00",
                             "6.10",
                             "3.00",
                             "1.80", // beside the window
                             "0.10", // the wall between the rooms
                             "1 : 50 on A4, lengths in metres"})
      EXPECT_THAT(words, Contains(text)) << angle;
    EXPECT_THAT(words, Not(Contains("0.90"))) << "the door is not at a side";
  }
}

TEST(PlanDrawing, TextsAreOnTheSheetAndNotOnEachOther)
{
  for (const double angle : {0.0, 0.3, 1.2}) {
    const PlanDrawing drawing = drawPlan(turned(planOfTwoRooms(), angle));
    TextPlaces places;
    for (const PlanText& text : textsOf(drawing)) {
      EXPECT_TRUE(places.areFree({text}, drawing.scale)) << text.text;
      places.take(text, drawing.scale);
      for (const Vector2d& corner : quadOf(text, drawing.scale))
        EXPECT_TRUE(drawing.sheet.contains(corner)) << text.text;
    }
  }
}

TEST(PlanDrawing, IsMadeForTheLargestScaleThatFits)
{
  const std::pair<double, double> scales[] = {
      {6, 50}, {30, 100}, {60, 200}, {100, 500}, {3000, 10000}};
  for (const auto& [length, scale] : scales) {
    FloorPlan plan;
    addWalls({{0, 0}, {length, 0}, {length, 3}, {0, 3}, {0, 0}}, plan);
    const PlanDrawing drawing = drawPlan(plan);
    EXPECT_EQ(drawing.scale, scale);
    const Vector2d paper = drawing.sheet.sizes() / drawing.metres(1);
    EXPECT_LE(paper.maxCoeff(), 420);
    EXPECT_LE(paper.minCoeff(), 297);
  }
}

TEST(PlanDrawing, UglyPlansAreDrawn)
{
  EXPECT_THAT(wordsOf(drawPlan({})), Contains("0 rooms, 0.0 m\u00B2 of floor"));
  FloorPlan plan = planOfTwoRooms();
  plan.walls.push_back({{1, 1}, {1, 1}, 0}); // no length
  plan.openings.push_back({{2, 2}, {2, 2}, 0});
  plan.rooms.emplace_back(); // without an outline
  plan.columns.push_back({{1, 1}, 0.2, 0, 7, false});
  plan.furniture.emplace_back();
  for (const PlanItem& item : drawPlan(plan).items)
    if (const auto* line = std::get_if<PlanLine>(&item.shape)) {
      for (const Vector2d& point : line->points)
        EXPECT_TRUE(point.allFinite());
    }
}

/** What is drawn of walls that were not seen. */
std::vector<std::vector<Vector2d>>
dashedLines(const PlanDrawing& drawing)
{
  std::vector<std::vector<Vector2d>> lines;
  for (const PlanItem& item : drawing.items)
    if (const auto* line = std::get_if<PlanLine>(&item.shape);
        line && line->pen.is_dashed && item.layer == PlanLayer::Walls)
      lines.push_back(line->points);
  return lines;
}

TEST(PlanDrawing, WhatWasNotSeenIsDashed)
{
  EXPECT_TRUE(dashedLines(drawPlan(planOfTwoRooms())).empty());
  FloorPlan plan = planOfTwoRooms();
  plan.walls[3].to = {0, 1}; // the corner at the origin is hidden
  plan.walls[4].from = {1, 0};
  addHiddenCorners(plan);
  ASSERT_EQ(plan.unseen_walls.size(), 2U);
  EXPECT_THAT(dashedLines(drawPlan(plan)),
              ElementsAre(ElementsAre(Vector2d(0, 1), Vector2d(0, 0)),
                          ElementsAre(Vector2d(0, 0), Vector2d(1, 0))));
  FloorPlan open = planOfTwoRooms();
  open.walls.erase(open.walls.begin() + 3); // the whole left wall
  addHiddenCorners(open);
  EXPECT_TRUE(open.unseen_walls.empty());
  const auto borders = dashedLines(drawPlan(open));
  ASSERT_EQ(borders.size(), 1U);
  for (const Vector2d& point : borders[0])
    EXPECT_NEAR(point.x(), 0, 1e-9);
}

TEST(PlanRaster, ShowsTheDrawing)
{
  constexpr double resolution = 4; // pixels for a millimetre
  const PlanDrawing drawing = drawPlan(planOfTwoRooms());
  const RgbImage image = rasterOf(drawing, resolution);
  const double pixels = resolution / drawing.metres(1);
  EXPECT_NEAR(image.width, pixels * drawing.sheet.sizes().x(), 1);
  EXPECT_NEAR(image.height, pixels * drawing.sheet.sizes().y(), 1);
  const auto colorAt = [&](double x, double y) {
    const std::uint8_t* const pixel =
        image.at(static_cast<std::int32_t>((x - drawing.sheet.min().x()) * pixels),
                 static_cast<std::int32_t>((drawing.sheet.max().y() - y) * pixels));
    return PlanColor{pixel[0], pixel[1], pixel[2]};
  };
  EXPECT_EQ(colorAt(4.05, 0.5), wall_color);
  EXPECT_EQ(colorAt(-0.04, 2.7), half_wall_color);
  EXPECT_EQ(colorAt(0.3, 0.3), floor_color);
  EXPECT_EQ(colorAt(4.05, 1.2), paper_color);
  EXPECT_EQ(colorAt(-0.2, 1.5), paper_color);
}

TEST(StrokeFont, WritesUtf8)
{
  EXPECT_EQ(widthOf(""), 0);
  EXPECT_GT(widthOf("Room 10"), widthOf("Room 1"));
  EXPECT_EQ(strokesOf("K\u00FCche").strokes, strokesOf("Kuche").strokes);
  EXPECT_NE(strokesOf("m\u00B2").strokes, strokesOf("m?").strokes);
  EXPECT_EQ(strokesOf("\u4E2D").strokes, strokesOf("\u6587").strokes) << "no glyph";
  for (const char* invalid : {"\xFF", "\xC3", "a\xE2\x82", "\xF0\x9F"})
    EXPECT_GT(widthOf(invalid), 0);
  for (const auto& stroke :
       strokesOf("The quick brown fox, 0123456789 (m\u00B2)").strokes)
    for (const Vector2d& point : stroke) {
      EXPECT_GE(point.y(), -0.5 - 1.0 / 3 - 1e-9) << "descenders";
      EXPECT_LE(point.y(), 0.5 + 1.0 / 6 + 1e-9);
    }
}

} // namespace
} // namespace pcl::acmap::test
