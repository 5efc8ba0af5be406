// Puts the RED effects where their console variable says.
#include "Effects/REDPlace.h"

#include "Lens/REDPostProcess.h"

namespace Drydock
{

FChainPlace GetREDPlace(int32 Turn)
{
	switch (GetREDPostProcessInsertion())
	{
	case EREDPostProcessInsertion::BeforeTranslucency:
		return {EChainPlace::BeforeTranslucency, Turn};
	case EREDPostProcessInsertion::AfterTranslucency:
		return {EChainPlace::AfterTranslucency, Turn};
	default:
		return {EChainPlace::AfterBloom, Turn};
	}
}

const char* DescribeREDPlace()
{
	switch (GetREDPostProcessInsertion())
	{
	case EREDPostProcessInsertion::BeforeTranslucency:
		return "; before separate translucency";
	case EREDPostProcessInsertion::AfterTranslucency:
		return "; after separate translucency";
	default:
		return "; after bloom";
	}
}

} // namespace Drydock
