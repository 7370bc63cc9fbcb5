#include "planner/surface/annulus.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "geometry/mesh_measure.hpp"
#include "planner/surface/centre_slit.hpp"
#include "sample_surfaces.hpp"

namespace volute::planner {
namespace {

using geometry::MeshTopology;

std::vector<Index> sheet_boundary_on_whole(const Annulus& annulus) {
  const auto topology = MeshTopology::build(annulus.sheet).value();
  std::vector<Index> result;
  for (Index v : topology.boundary_loops().at(0).vertices)
    result.push_back(
        annulus.ring_to_whole[static_cast<std::size_t>(annulus.sheet_to_ring[static_cast<std::size_t>(v)])]);
  return result;
}

/// The same closed chain, wherever it starts?
bool same_cycle(const std::vector<Index>& a, std::vector<Index> b) {
  for (std::size_t i = 0; i < b.size() && a.size() == b.size(); ++i) {
    if (a == b) return true;
    std::rotate(b.begin(), b.begin() + 1, b.end());
  }
  return false;
}

class AnnulusWithHoles : public testing::TestWithParam<int> {};

TEST_P(AnnulusWithHoles, IsARingAndASheet) {
  const auto annulus = make_annulus(samples::random_plate(100U + static_cast<unsigned>(GetParam()), GetParam()));
  ASSERT_TRUE(annulus) << annulus.error().message;
  const auto ring = MeshTopology::build(annulus->ring), sheet = MeshTopology::build(annulus->sheet),
             whole = MeshTopology::build(annulus->whole);
  ASSERT_TRUE(ring && sheet && whole);
  EXPECT_EQ(ring->boundary_loops().size(), 2U);
  EXPECT_EQ(ring->components()[0].handles, 0);
  EXPECT_EQ(sheet->boundary_loops().size(), 1U);
  EXPECT_EQ(annulus->centre_is_slit, GetParam() == 0);
  EXPECT_EQ(annulus->bridges.size(), static_cast<std::size_t>(std::max(GetParam(), 1)));
  EXPECT_EQ(whole->boundary_loops().size(), static_cast<std::size_t>(GetParam() + 1));
}

TEST_P(AnnulusWithHoles, NoTriangleOfTheSheetHasItsThreeVerticesOnTheBoundary) {
  const auto annulus = make_annulus(samples::random_plate(200U + static_cast<unsigned>(GetParam()), GetParam()));
  ASSERT_TRUE(annulus) << annulus.error().message;
  const auto sheet = MeshTopology::build(annulus->sheet).value();
  for (const geometry::Triangle& t : annulus->sheet.triangles)
    EXPECT_FALSE(std::all_of(t.begin(), t.end(), [&](Index v) { return sheet.is_boundary_vertex(v); }));
}

TEST_P(AnnulusWithHoles, TheSingleBoundaryCurveOfThePaperIsTheBoundaryOfTheSheet) {
  if (GetParam() == 0) return;  // a disk has no bridges
  const auto annulus = make_annulus(samples::random_plate(300U + static_cast<unsigned>(GetParam()), GetParam()));
  ASSERT_TRUE(annulus) << annulus.error().message;
  EXPECT_TRUE(same_cycle(connected_boundary(annulus->curves, annulus->bridges), sheet_boundary_on_whole(*annulus)));
  const auto segments = segments_between(annulus->curves, annulus->bridges);
  EXPECT_EQ(segments.size(), 2 * annulus->bridges.size()) << "every bridge end starts one segment";
  EXPECT_EQ(std::count_if(annulus->bridges.begin(), annulus->bridges.end(),
                          [](const Bridge& b) { return b.from_curve == 0; }),
            1)
      << "only one hole is joined to the outer boundary";
}

INSTANTIATE_TEST_SUITE_P(Holes, AnnulusWithHoles, testing::Values(0, 1, 2, 3, 5, 8));

TEST(Annulus, OuterAndInnerRunTheSameWayFromTheSeam) {
  const auto annulus = make_annulus(samples::ring(5.0, 15.0, 60, 10));
  ASSERT_TRUE(annulus) << annulus.error().message;
  EXPECT_EQ(annulus->outer.front(), annulus->seam.front());
  EXPECT_EQ(annulus->inner.front(), annulus->seam.back());
  for (const auto* loop : {&annulus->outer, &annulus->inner}) {
    const Vec3 &p = annulus->ring.vertices_mm[static_cast<std::size_t>((*loop)[0])],
               &q = annulus->ring.vertices_mm[static_cast<std::size_t>((*loop)[1])];
    EXPECT_GT(p.cross(q).z(), 0.0) << "counter-clockwise";
  }
}

TEST(Annulus, TheCentreLoopIsTheUsersChoice) {
  samples::PlateOptions o;
  o.holes = {{-10, 0, 5}, {0, 0, 3}, {10, 0, 4}};
  const TriangleMesh mesh = samples::plate(o);
  for (int loop : {1, 2, 3}) {
    AnnulusOptions options;
    options.centre_loop = loop;
    const auto annulus = make_annulus(mesh, options);
    ASSERT_TRUE(annulus);
    EXPECT_EQ(annulus->bridges[0].to_curve, loop);
  }
  AnnulusOptions options;
  options.centre_loop = 4;
  EXPECT_EQ(make_annulus(mesh, options).error().code, "surface-centre-loop");
}

TEST(Annulus, WhatCannotBeLaidFlatIsRefused) {
  TriangleMesh two = samples::ring(5.0, 15.0, 20, 4);
  const TriangleMesh other = samples::ring(1.0, 2.0, 20, 4);
  const auto shift = static_cast<Index>(two.vertices_mm.size());
  for (const Vec3& v : other.vertices_mm) two.vertices_mm.push_back(v + Vec3(100, 0, 0));
  for (geometry::Triangle t : other.triangles) two.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  EXPECT_EQ(make_annulus(two).error().code, "surface-several-components");
  const TriangleMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  EXPECT_EQ(make_annulus(tetrahedron).error().code, "surface-closed");
}

TEST(CentreSlit, LiesOnTheLongAxisOfAnEllipseAndShrinksOnADisk) {
  samples::PlateOptions o;
  o.width_mm = 60.0;
  o.depth_mm = 30.0;
  o.columns = 80;
  const TriangleMesh plate = samples::plate(o);
  const auto slit = centre_slit(plate, MeshTopology::build(plate).value());
  ASSERT_TRUE(slit);
  const Vec3 a = position_mm(plate, slit->front()), b = position_mm(plate, slit->back());
  EXPECT_LT((a + b).norm(), 2.0);
  EXPECT_GT((b - a).norm(), 15.0);
  EXPECT_LT(std::abs(b.y() - a.y()), 2.0);
  o.width_mm = 30.0;
  o.columns = 40;
  const TriangleMesh square = samples::plate(o);
  EXPECT_LT(length_mm(square, centre_slit(square, MeshTopology::build(square).value()).value()), 3.0);
}

}  // namespace
}  // namespace volute::planner
