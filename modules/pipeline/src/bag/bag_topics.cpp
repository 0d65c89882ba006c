#include "bag/bag_topics.h"

#include <pcl/pipeline/stage_store.h>

#include <algorithm>
#include <cmath>

namespace pcl::acmap {

namespace {

/** \brief sensor_msgs/Image of sensor_msgs/msg/Image. */
std::string
typeOfRos1(std::string type)
{
  const std::string infix = "/msg/";
  if (const std::size_t place = type.find(infix); place != type.npos)
    type.replace(place, infix.size(), "/");
  return type;
}

std::string
secondsText(double seconds)
{
  return std::to_string(static_cast<long long>(std::ceil(seconds))) + " s";
}

} // namespace

bool
endsWith(const std::string& text, const std::string& ending)
{
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

BagTopics::BagTopics(const std::string& path)
: bag_(path)
, remarks_(bag_.remarks())
{
  listTopics();
  takeTransforms();
  takeOdometry();
  takeSingleTransforms();
}

void
BagTopics::listTopics()
{
  for (const BagMessage& message : bag_.messages()) {
    const BagChannel& channel = bag_.channels()[message.channel];
    const bool is_ros1 = channel.encoding == "ros1";
    if (!is_ros1 && channel.encoding != "cdr")
      continue;
    BagTopic& topic = topics_[channel.topic];
    const std::string type = typeOfRos1(channel.type);
    if (topic.messages.empty())
      topic = {channel.topic,
               type,
               is_ros1 ? RosSerialization::Ros1 : RosSerialization::Cdr,
               {}};
    if (topic.type == type)
      topic.messages.push_back(message);
  }
}

void
BagTopics::takeTransforms()
{
  for (const char* type : {"tf2_msgs/TFMessage", "tf/tfMessage"})
    for (const BagTopic* topic : ofType(type))
      for (const BagMessage& message : topic->messages)
        for (const RosTransform& transform : read(*topic, message, readRosTransforms))
          tree_.add(transform, endsWith(topic->name, "tf_static"));
}

void
BagTopics::takeOdometry()
{
  std::vector<std::string> taken;
  for (const BagTopic* topic : ofType("nav_msgs/Odometry")) {
    addUnlessKnown(*topic, taken);
    tree_.setTracked(read(*topic, topic->messages.front(), readRosOdometry).child);
  }
}

/** Motion capture publishes the transform of each body on a topic of its own. */
void
BagTopics::takeSingleTransforms()
{
  std::vector<std::string> taken;
  for (const BagTopic* topic : ofType("geometry_msgs/TransformStamped"))
    addUnlessKnown(*topic, taken);
}

/** \brief Adds the poses of a topic of Odometry, or of TransformStamped, which begins alike.
 * \param[in,out] taken frames that such topics have */
void
BagTopics::addUnlessKnown(const BagTopic& topic, std::vector<std::string>& taken)
{
  const std::string child = read(topic, topic.messages.front(), readRosOdometry).child;
  if (tree_.hasParent(child) || std::count(taken.begin(), taken.end(), child) > 0)
    return;
  taken.push_back(child);
  for (const BagMessage& message : topic.messages)
    tree_.add(read(topic, message, readRosOdometry), false);
}

std::vector<const BagTopic*>
BagTopics::ofType(const std::string& type) const
{
  std::vector<const BagTopic*> topics;
  for (const auto& [name, topic] : topics_)
    if (topic.type == type)
      topics.push_back(&topic);
  return topics;
}

const BagTopic*
BagTopics::largestOf(const std::string& type) const
{
  const std::vector<const BagTopic*> topics = ofType(type);
  const auto largest = std::max_element(
      topics.begin(), topics.end(), [](const BagTopic* a, const BagTopic* b) {
        return a->messages.size() < b->messages.size();
      });
  return largest == topics.end() ? nullptr : *largest;
}

std::string
BagTopics::list() const
{
  constexpr std::size_t max_named = 30;
  std::string list;
  const std::vector<BagChannel>& channels = bag_.channels();
  for (std::size_t i = 0; i < std::min(channels.size(), max_named); ++i) {
    const BagChannel& channel = channels[i];
    const bool is_read = channel.encoding == "cdr" || channel.encoding == "ros1";
    list += (list.empty() ? "" : ", ") + channel.topic + " (" +
            std::to_string(channel.messages) + " of " + channel.type +
            (is_read ? "" : ", serialized as '" + channel.encoding + "'") + ")";
  }
  if (channels.empty())
    return "it has none";
  return list + (channels.size() > max_named ? ", ..." : "");
}

std::string
BagTopics::placeOf(const BagTopic& topic) const
{
  return bag_.path() + ": " + topic.name;
}

std::vector<double>
BagTopics::sortByStamps(BagTopic& topic)
{
  std::vector<double> stamps;
  for (const BagMessage& message : topic.messages)
    stamps.push_back(read(topic, message, readRosHeader).stamp);
  const bool are_stamped =
      std::adjacent_find(stamps.begin(), stamps.end(), std::not_equal_to<>()) !=
      stamps.end();
  if (!are_stamped && stamps.size() > 1) {
    remark("the messages of " + topic.name +
           " have no stamps; the times of their recording were taken");
    for (std::size_t i = 0; i < stamps.size(); ++i)
      stamps[i] = topic.messages[i].time;
  }
  double back = 0;
  for (std::size_t i = 1; i < stamps.size(); ++i)
    back = std::max(back, stamps[i - 1] - stamps[i]);
  constexpr double reordered = 1; // seconds: more is no delay of a message
  if (back > reordered)
    remark("the clock of " + topic.name + " jumps back by up to " + secondsText(back) +
           "; its messages were taken in the order of their stamps");
  std::vector<double> rising;
  std::vector<BagMessage> messages;
  for (const std::size_t i : risingOrder(stamps)) {
    rising.push_back(stamps[i]);
    messages.push_back(topic.messages[i]);
  }
  topic.messages = std::move(messages);
  return rising;
}

void
BagTopics::fail(const std::string& fault) const
{
  throw InputFileException(bag_.path() + ": " + fault);
}

void
BagTopics::remark(const std::string& text)
{
  remarks_.push_back(bag_.path() + ": " + text);
}

std::string
BagTopics::fingerprint() const
{
  std::string state;
  for (const std::string& file : bag_.files())
    state += stateOfFile(file) + "\n";
  return state;
}

} // namespace pcl::acmap
