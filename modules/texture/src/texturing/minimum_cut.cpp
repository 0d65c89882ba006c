#include "texturing/minimum_cut.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

#include <algorithm>

namespace pcl::acmap::texturing {

namespace {

using Edge = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>::
    edge_descriptor;
using FlowGraph = boost::adjacency_list<
    boost::vecS,
    boost::vecS,
    boost::directedS,
    boost::no_property,
    boost::property<boost::edge_capacity_t,
                    std::int64_t,
                    boost::property<boost::edge_residual_capacity_t,
                                    std::int64_t,
                                    boost::property<boost::edge_reverse_t, Edge>>>>;

void
connect(std::size_t from, std::size_t to, std::int64_t capacity, FlowGraph& graph)
{
  const Edge there = boost::add_edge(from, to, graph).first;
  const Edge back = boost::add_edge(to, from, graph).first;
  boost::put(boost::edge_capacity, graph, there, capacity);
  boost::put(boost::edge_capacity, graph, back, 0);
  boost::put(boost::edge_reverse, graph, there, back);
  boost::put(boost::edge_reverse, graph, back, there);
}

} // namespace

MinimumCut::MinimumCut(std::size_t nodes)
: of_moving_(nodes, 0)
{}

void
MinimumCut::add(std::size_t node, std::int64_t stays, std::int64_t moves)
{
  of_moving_[node] += moves - stays;
}

/** Kolmogorov, Zabih 2004: two terms of the nodes, and one of the pair. */
void
MinimumCut::addPair(std::size_t first,
                    std::size_t second,
                    std::int64_t stay,
                    std::int64_t second_moves,
                    std::int64_t first_moves,
                    std::int64_t move)
{
  of_moving_[first] += first_moves - stay;
  of_moving_[second] += move - first_moves;
  const std::int64_t cost = second_moves + first_moves - stay - move;
  if (cost > 0)
    pairs_.push_back({first, second, cost});
}

std::vector<bool>
MinimumCut::solve()
{
  const std::size_t source = of_moving_.size(), sink = source + 1;
  FlowGraph graph(sink + 1);
  for (std::size_t node = 0; node < of_moving_.size(); ++node)
    if (of_moving_[node] > 0)
      connect(source, node, of_moving_[node], graph);
    else
      connect(node, sink, -of_moving_[node], graph);
  for (const Pair& pair : pairs_)
    connect(pair.first, pair.second, pair.cost, graph);
  std::vector<boost::default_color_type> colors(sink + 1);
  const auto index = boost::get(boost::vertex_index, graph);
  boost::boykov_kolmogorov_max_flow(
      graph,
      boost::get(boost::edge_capacity, graph),
      boost::get(boost::edge_residual_capacity, graph),
      boost::get(boost::edge_reverse, graph),
      boost::make_iterator_property_map(colors.begin(), index),
      index,
      source,
      sink);
  std::vector<bool> moves;
  for (std::size_t node = 0; node < source; ++node)
    moves.push_back(colors[node] == boost::white_color); // the tree of the sink
  return moves;
}

} // namespace pcl::acmap::texturing
