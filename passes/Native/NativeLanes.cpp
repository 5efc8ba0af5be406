// Finds the lanes of native kernels.
#include "Native/NativeLanes.h"

#include "LanesDispatch.h"
#include "ShaderCompilation.h"

#include <algorithm>

namespace Drydock
{

int32 GetNativeLanes()
{
	FLaneConfig Config;
	const int32 Wanted = GetShaderLaneConfig().Lanes;
	Config.Lanes = Wanted > 0 ? std::min(Wanted, GetWidestLanes(false)) : 0;
	return ResolveLanes(Config).Lanes;
}

} // namespace Drydock
