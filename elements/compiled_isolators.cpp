#include "elements/compiled_blocks.hpp"

namespace moat {

template LinkBlock<BoucWen>& Model::block();
template LinkBlock<Repeated<BoucWen>>& Model::block();
template LinkBlock<GrantRubber>& Model::block();
template LinkBlock<Repeated<GrantRubber>>& Model::block();
template LinkBlock<HeatedLeadRubber>& Model::block();
template LinkBlock<Repeated<HeatedLeadRubber>>& Model::block();
template LinkBlock<HeatedSlidingIsolator>& Model::block();
template LinkBlock<Repeated<HeatedSlidingIsolator>>& Model::block();
template LinkBlock<KikuchiAikenRubber>& Model::block();
template LinkBlock<Repeated<KikuchiAikenRubber>>& Model::block();
template LinkBlock<SeriesOfSliders>& Model::block();
template LinkBlock<Repeated<SeriesOfSliders>>& Model::block();
template LinkBlock<SlidingIsolator>& Model::block();
template LinkBlock<Repeated<SlidingIsolator>>& Model::block();
template LinkBlock<StiffeningSpring>& Model::block();
template LinkBlock<Repeated<StiffeningSpring>>& Model::block();

}  // namespace moat
