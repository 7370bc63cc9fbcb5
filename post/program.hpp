// One program being written: the order of its parts. Private to post.
#pragma once

#include "post/block_writer.hpp"
#include "post/feed.hpp"
#include "post/post.hpp"
#include "post/template_line.hpp"

namespace volute::post {

class Program {
 public:
  Program(const PostRequest& request, const kinematics::Profile& profile, const kinematics::AxisPath& path);

  void begin();                                        ///< header: units, tool, spindle, work offset, Z at the top
  void enter(const kinematics::AxisPathPoint& point);  ///< rotaries and X Y at the top, TCP on, down to the point
  void motion();                                       ///< the path; leaves and enters again at every rewind
  void leave();                                        ///< TCP off, Z to the top
  void end();                                          ///< rotaries home, coolant and spindle off, end of program

  /// Errors (bad_input): post-field, post-block-too-long, post-feed-too-slow.
  Result<PostResult> finish();

 private:
  void lines(const std::vector<std::string>& templates);
  void write_point(const kinematics::AxisPathPoint& from, const kinematics::AxisPathPoint& to);
  void set_feed_unit(FeedUnit unit);
  [[nodiscard]] BlockWords words_of(const kinematics::AxisPathPoint& point) const;
  [[nodiscard]] std::array<double, 2> rotary_words(const kinematics::AxisVector& q) const;
  void prepare_fields();
  void prepare_box();
  void refuse(geometry::Error error);

  const PostRequest& request_;
  const kinematics::Machine& machine_;
  const kinematics::Control& control_;
  const kinematics::AxisPath& path_;
  kinematics::AxisVector zero_;
  BlockWriter writer_;
  Fields fields_;
  FeedUnit feed_unit_ = FeedUnit::per_minute;
  std::int64_t clamped_ = 0;
  bool first_entry_ = true;
  std::optional<geometry::Error> error_;
};

}  // namespace volute::post
