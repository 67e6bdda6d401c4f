// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "../common/refusal.h"
#include "../scenario/temporary_directory.h"
#include "smore/ros/prior_request.h"

namespace smore {
namespace {

using Request = smore_msgs::InsertPrior::Request;

constexpr std::uint32_t kRowPadding = 7;  // [bytes] as cameras' drivers have it

sensor_msgs::PointField field(const std::string& name, std::uint32_t offset) {
  sensor_msgs::PointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = sensor_msgs::PointField::FLOAT32;
  field.count = 1;
  return field;
}

// Two rows of two points: x, a colour, y and z; one of them is not finite.
sensor_msgs::PointCloud2 someCloud() {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::vector<float>> points = {{1.0F, 0.0F, 2.0F, 3.0F},
                                                  {4.0F, 0.0F, 5.0F, 6.0F},
                                                  {nan, 0.0F, 0.0F, 0.0F},
                                                  {-1.0F, 0.0F, -2.0F, -3.0F}};
  sensor_msgs::PointCloud2 cloud;
  cloud.header.frame_id = "world";
  cloud.width = 2;
  cloud.height = 2;
  cloud.point_step = 16;
  cloud.row_step = 2 * cloud.point_step + kRowPadding;
  cloud.fields = {field("x", 0), field("rgb", 4), field("y", 8), field("z", 12)};
  cloud.data.resize(std::size_t{2} * cloud.row_step);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::memcpy(&cloud.data[(i / 2) * cloud.row_step + (i % 2) * cloud.point_step],
                points[i].data(), cloud.point_step);
  }
  return cloud;
}

Request cloudRequest() {
  Request request;
  request.map = "world";
  request.cloud = someCloud();
  return request;
}

Result<Pose> nowhere(const std::string& /*target*/, const std_msgs::Header& /*cloud*/) {
  return Failure{"no such frame"};
}

std::string problemOf(const Request& request) {
  return refusalOf([&] { return readRequest(request, FrameNames{}, nowhere); });
}

TEST(PriorRequest, givesThePointsOfACloudThatAreFinite) {
  const PriorRequest told = readRequest(cloudRequest(), FrameNames{}, nowhere);
  EXPECT_EQ(told.side, MapSide::kWorld);
  EXPECT_EQ(told.source.format, PriorFormat::kCloud);
  ASSERT_EQ(told.source.points.size(), 3U);
  EXPECT_EQ(told.source.points[1], Vec3(4.0, 5.0, 6.0));
  EXPECT_EQ(told.source.points[2], Vec3(-1.0, -2.0, -3.0));
  EXPECT_EQ(told.source.confidence, 0.999);
  EXPECT_FALSE(told.source.box);
  EXPECT_TRUE(told.source.pose.isApprox(Pose::Identity()));
}

TEST(PriorRequest, takesFilePoseBoxScaleAndConfidence) {
  const TemporaryDirectory directory;
  Request request;
  request.map = "object";
  request.file = directory.write("part.stl", "");
  request.pose.position.x = 0.5;
  request.pose.orientation.w = 1.0;
  request.scale.x = request.scale.y = request.scale.z = 0.001;
  request.min.z = -0.1;
  request.max.x = request.max.y = request.max.z = 0.2;
  request.confidence = 0.7;
  const auto [side, source] = readRequest(request, FrameNames{}, nowhere);
  EXPECT_EQ(side, MapSide::kObject);
  EXPECT_EQ(source.format, PriorFormat::kMesh);
  EXPECT_EQ(source.pose.translation(), Vec3(0.5, 0.0, 0.0));
  EXPECT_EQ(source.scale, Vec3::Constant(0.001));
  EXPECT_EQ(source.confidence, 0.7);
  EXPECT_EQ(problemOf(request), "") << "a box may begin at zero";
  ASSERT_TRUE(source.box);
  EXPECT_EQ(source.box->min, Vec3(0.0, 0.0, -0.1));
}

TEST(PriorRequest, takesACloudOfAnUnknownFrameOnlyWithThatFramesPose) {
  Request request = cloudRequest();
  request.cloud.header.frame_id = "camera";
  EXPECT_NE(problemOf(request).find("'camera'"), std::string::npos);
  EXPECT_NE(problemOf(request).find("no such frame"), std::string::npos);
  request.pose.orientation.w = 1.0;
  EXPECT_EQ(problemOf(request), "");
}

TEST(PriorRequest, placesACloudOfAnotherFrameInThatOfItsMap) {
  Request request = cloudRequest();
  request.map = "object";
  request.cloud.header.frame_id = "camera";
  request.cloud.header.stamp = ros::Time(3.0);
  const Pose T_object_camera = makePose(Vec3(0.1, 0.2, 0.3), Vec3(0.4, 0.5, 0.6));
  const PriorRequest told =
      readRequest(request, FrameNames{}, [&](const auto& target, const auto& cloud) {
        EXPECT_EQ(target, "object");
        EXPECT_EQ(cloud.frame_id, "camera");
        EXPECT_EQ(cloud.stamp, ros::Time(3.0));
        return Result<Pose>(T_object_camera);
      });
  EXPECT_TRUE(told.source.pose.isApprox(T_object_camera));
}

TEST(PriorRequest, asksForNoFrameWhereThePoseIsGivenOrTheCloudIsInThatOfItsMap) {
  const auto fail = [](const auto& /*target*/, const auto& /*cloud*/) {
    ADD_FAILURE();
    return Result<Pose>(Failure{"asked"});
  };
  Request request = cloudRequest();
  EXPECT_TRUE(readRequest(request, FrameNames{}, fail).source.pose.isApprox(Pose::Identity()));
  request.cloud.header.frame_id = "camera";
  request.pose.position.y = 0.5;
  request.pose.orientation.w = 1.0;
  EXPECT_EQ(readRequest(request, FrameNames{}, fail).source.pose.translation(),
            Vec3(0.0, 0.5, 0.0));
}

TEST(PriorRequest, namesWhatIsWrong) {
  const auto expect = [](const char* says, const std::function<void(Request*)>& spoil) {
    Request request = cloudRequest();
    spoil(&request);
    EXPECT_NE(problemOf(request).find(says), std::string::npos) << says << problemOf(request);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect("'moon'", [](Request* r) { r->map = "moon"; });
  expect("either", [](Request* r) { r->file = "/part.stl"; });
  expect("either", [](Request* r) { r->cloud = {}; });
  expect("absolute", [](Request* r) { r->cloud = {}, r->file = "part.stl"; });
  expect("no file", [](Request* r) { r->cloud = {}, r->file = "/missing/part.stl"; });
  expect("none of", [](Request* r) { r->cloud = {}, r->file = "/proc/version"; });
  expect("no field y", [](Request* r) { r->cloud.fields[2].name = "v"; });
  expect("no field x",
         [](Request* r) { r->cloud.fields[0].datatype = sensor_msgs::PointField::INT32; });
  expect("no field z", [](Request* r) { r->cloud.fields[3].offset = 13; });
  expect("fewer data", [](Request* r) { r->cloud.data.pop_back(); });
  expect("fewer data", [](Request* r) { r->cloud.row_step = 8; });
  expect("fewer data", [](Request* r) { r->cloud.height = 4000000000; });
  expect("big-endian", [](Request* r) { r->cloud.is_bigendian = 1; });
  expect("no point", [](Request* r) { r->cloud.height = 0; });
  expect("pose", [](Request* r) { r->pose.orientation.w = 0.5; });
  expect("pose", [nan](Request* r) { r->pose.position.x = nan, r->pose.orientation.w = 1.0; });
  expect("pose", [](Request* r) { r->pose.position.x = 1e3, r->pose.orientation.w = 1.0; });
  expect("min", [](Request* r) { r->max.x = 1.0; });
  expect("min", [nan](Request* r) { r->max.x = nan; });
  expect("scale", [nan](Request* r) { r->scale.x = nan; });
  expect("confidence", [](Request* r) { r->confidence = 1.0; });
  expect("confidence", [nan](Request* r) { r->confidence = nan; });
}

}  // namespace
}  // namespace smore
