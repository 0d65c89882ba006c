#include "recipe.h"

namespace pcl::acmap {

MatchingRecipe
recipeOf(std::size_t shots, bool lit)
{
  MatchingRecipe recipe;
  if (shots >= 5) {
    recipe.min_correlation = 0.75;
    return recipe;
  }
  if (shots >= 3) {
    recipe.cost = PairCost::Windows;
    recipe.radius = 1;
    return recipe;
  }
  recipe.centred = false;
  recipe.min_deviation = 1.0;
  recipe.min_correlation = 0.2;
  if (shots == 2) {
    recipe.cost = PairCost::Windows;
    recipe.radius = 2;
    recipe.small_penalty = 300;
    recipe.large_penalty = 2000;
    return recipe;
  }
  recipe.cost = PairCost::Census;
  recipe.blur = 0.57;
  recipe.small_penalty = 700;
  recipe.large_penalty = 2500;
  recipe.contrast = 60;
  if (!lit) {
    recipe.blur = 0.3;
    recipe.cost_of_bit = 15;
    recipe.min_deviation = 0.0;
    recipe.min_correlation = -1.0;
  }
  return recipe;
}

} // namespace pcl::acmap
