#include "mesh_arrays.h"

namespace pcl::acmap::ACMAP_DEWALL {

Edge&
MeshArrays::addEdge(std::int32_t a, std::int32_t b, EdgePool::Cursor& memory)
{
  Vertex& low = vertex(std::min(a, b));
  EdgeBlock* block = &low.first_edges;
  std::int32_t* more = &low.more_edges;
  while (*more >= 0) {
    block = &edges[*more].block;
    more = &edges[*more].next;
  }
  unsigned free = bitsOfEqual(block->high, EdgeBlock::empty);
  if (!free) {
    *more = memory.take();
    block = &edges[*more].block;
    free = 1;
  }
  const unsigned place = lowestBit(free);
  block->high[place] = std::max(a, b);
  return block->edges[place];
}

void
MeshArrays::removeEdge(std::int32_t a, std::int32_t b, EdgePool::Cursor& memory)
{
  Vertex& low = vertex(std::min(a, b));
  EdgeBlock* block = &low.first_edges;
  std::int32_t* more = &low.more_edges;
  unsigned found = bitsOfEqual(block->high, std::max(a, b));
  while (!found) {
    block = &edges[*more].block;
    more = &edges[*more].next;
    found = bitsOfEqual(block->high, std::max(a, b));
  }
  // The following edges move up by one place.
  unsigned place = lowestBit(found);
  for (;;) {
    for (; place + 1 < EdgeBlock::capacity; ++place) {
      block->high[place] = block->high[place + 1];
      block->edges[place] = block->edges[place + 1];
    }
    block->high[place] = EdgeBlock::empty;
    if (*more < 0)
      return;
    EdgeBlock& next = edges[*more].block;
    block->high[place] = next.high[0];
    block->edges[place] = next.edges[0];
    if (next.high[1] == EdgeBlock::empty) { // it becomes empty, and is the last one
      memory.giveBack(*more);
      *more = -1;
      return;
    }
    more = &edges[*more].next;
    block = &next;
    place = 0;
  }
}

} // namespace pcl::acmap::ACMAP_DEWALL
