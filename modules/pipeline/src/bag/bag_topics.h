#pragma once

#include "bag/frame_tree.h"

#include <pcl/core/bag_file.h>
#include <pcl/core/ros_messages.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace pcl::acmap {

/** \brief Type of laser scans. */
constexpr const char* scan_type = "sensor_msgs/LaserScan";

/** \brief A topic with its messages in the order of the file. */
struct BagTopic {
  std::string name;
  std::string type; ///< as ROS 1 names it: sensor_msgs/Image
  RosSerialization serialization = RosSerialization::Cdr;
  std::vector<BagMessage> messages;
};

/** \brief What a bag has: its topics, and the tree of its frames. */
class BagTopics {
public:
  /** \throws InputFileException as \ref BagFile, and for malformed transforms */
  explicit BagTopics(const std::string& path);

  const BagFile&
  bag() const
  {
    return bag_;
  }

  /** \brief Those whose messages are serialized as CDR or as ROS 1 does, by name. */
  const std::map<std::string, BagTopic>&
  all() const
  {
    return topics_;
  }

  /** \brief Those of a type. */
  std::vector<const BagTopic*>
  ofType(const std::string& type) const;

  /** \brief The topic of a type that has most messages; null if there is none. */
  const BagTopic*
  largestOf(const std::string& type) const;

  /** \brief All topics of the bag with types and numbers of messages, for messages. */
  std::string
  list() const;

  /** \brief Name of a topic in this bag, for messages. */
  std::string
  placeOf(const BagTopic& topic) const;

  /** \brief Reads a message.
   * \param[in] reader such as readRosImage */
  template <typename Result>
  Result
  read(const BagTopic& topic,
       const BagMessage& message,
       Result (*reader)(std::string_view, const std::string&, RosSerialization)) const
  {
    return reader(bag_.load(message), placeOf(topic), topic.serialization);
  }

  /** \brief Sorts the messages of a topic by their stamps.
   * \return the stamps, seconds: of their headers, or of their recording where these are
   * all the same */
  std::vector<double>
  sortByStamps(BagTopic& topic);

  FrameTree&
  tree()
  {
    return tree_;
  }

  const FrameTree&
  tree() const
  {
    return tree_;
  }

  [[noreturn]] void
  fail(const std::string& fault) const;

  void
  remark(const std::string& text);

  const std::vector<std::string>&
  remarks() const
  {
    return remarks_;
  }

  /** \brief Changes with the files of the bag. */
  std::string
  fingerprint() const;

private:
  void
  listTopics();

  void
  takeTransforms();

  void
  takeOdometry();

  void
  takeSingleTransforms();

  void
  addUnlessKnown(const BagTopic& topic, std::vector<std::string>& taken);

  BagFile bag_;
  std::map<std::string, BagTopic> topics_;
  FrameTree tree_;
  std::vector<std::string> remarks_;
};

/** \brief Does a text end with another one? */
bool
endsWith(const std::string& text, const std::string& ending);

} // namespace pcl::acmap
