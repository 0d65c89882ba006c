#include "report_page.h"

namespace pcl::acmap {

const char*
pageStyle()
{
  return R"css(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body {
  max-width: 72rem; margin: 0 auto; padding: 1rem;
  background: #fff; color: #1c1c1c;
  font: 1rem/1.5 system-ui, "Noto Sans", "DejaVu Sans", sans-serif;
  overflow-wrap: anywhere;
}
h1 { margin: 0; font-size: 1.8rem; line-height: 1.25; }
h2 { margin: 2.2rem 0 .6rem; font-size: 1.3rem; border-bottom: 1px solid #ccc; }
h3 { margin: 0 0 .3rem; font-size: 1.05rem; }
p { margin: .5rem 0; }
.origin, .legend, figcaption { color: #505050; }
.result { margin: 1rem 0; font-size: 1.15rem; }
pre {
  margin: .8rem 0; padding: .6rem .8rem; background: #f3f3f3; font-size: .9rem;
  white-space: pre-wrap;
}
.warnings { margin: 1rem 0; padding: .6rem 1rem; border: 2px solid #b36b00;
  background: #fff6e5; }
.warnings h2 { margin: 0; border: 0; color: #7a4900; font-size: 1.1rem; }
.warnings ul { margin: .3rem 0; padding-left: 1.2rem; }
.missing { padding: .6rem .8rem; border: 1px dashed #b36b00; }
.pictures, .cards { display: grid; gap: 1rem 1.5rem;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 26rem), 1fr)); }
figure { margin: 0; }
img { display: block; max-width: 100%; width: auto; height: auto; max-height: 44rem;
  margin: 0 auto; border: 1px solid #ddd; }
figcaption { margin-top: .3rem; text-align: center; font-size: .95rem; }
.wide { overflow-x: auto; overflow-wrap: normal; }
svg { display: block; width: 100%; font-size: 15px; }
path { vector-effect: non-scaling-stroke; }
.legend span { margin-left: .8rem; white-space: nowrap; }
table { border-collapse: collapse; width: 100%; font-size: .95rem; }
th, td { padding: .2rem .5rem; text-align: left; vertical-align: top;
  border-bottom: 1px solid #e3e3e3; }
thead th, tfoot th, tfoot td { border-bottom: 1px solid #888; font-weight: 600; }
tbody th { font-weight: 400; }
.pairs th { width: 35%; color: #505050; }
.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
.equation { white-space: nowrap; font-variant-numeric: tabular-nums; }
.seconds .stage th, .seconds .stage td { border-top: 1px solid #888; font-weight: 600; }
.seconds .step th { padding-left: 1.5rem; color: #505050; }
.seconds .bars { width: 50%; }
.seconds em { font-weight: 400; }
.bar { display: block; height: .8rem; margin-top: .35rem; background: #195abe;
  print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.step .bar { height: .5rem; margin-top: .5rem; opacity: .55; }
.reused .bar { background: repeating-linear-gradient(45deg, #999 0 3px, #ddd 3px 6px); }
@media screen and (max-width: 40rem) {
  svg { font-size: 26px; }
  table { font-size: .85rem; }
  th, td { padding: .2rem; }
  .equation, thead .number { white-space: normal; }
}
@media print {
  body { max-width: none; padding: 0; font-size: 10pt; }
  h2, h3 { break-after: avoid; }
  figure, tr, .cards section, svg { break-inside: avoid; }
  .pictures, .cards { grid-template-columns: 1fr 1fr; }
  img { max-height: 6cm; }
}
)css";
}

} // namespace pcl::acmap
