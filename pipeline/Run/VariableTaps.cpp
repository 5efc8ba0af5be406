// Counts taps where a loop's length is a parameter.
#include "Run/VariableTaps.h"

#include "RenderGraphPass.h"
#include "Run/PassMember.h"
#include "ShaderParameterMetadata.h"

#include <algorithm>

namespace Drydock
{

std::optional<uint64_t> CountTaps(const FRDGPass& Pass, const FPassCounters& Counters)
{
	if (Counters.TapCount != ETapCount::Unknown)
	{
		return Counters.Taps;
	}
	if (!EnumHasAnyFlags(Counters.Ran, EShaderRun::NativeKernel) || Pass.GetParameters() == nullptr ||
		Pass.GetParametersMetadata() == nullptr)
	{
		return std::nullopt;
	}
	int64_t PerPixel = 0;
	for (const FHlslMember& Member : Pass.GetParametersMetadata()->GetHlslMembers())
	{
		if (Member.Name == "SampleCount" && Member.BaseType == UBMT_INT32)
		{
			PerPixel += ReadMember<int32>(Pass, Member);
		}
		else if (Member.Name == "Additive_Texture")
		{
			PerPixel += ReadMember<const void*>(Pass, Member) != nullptr ? 1 : 0;
		}
		else if (Member.Name == "Reach" && Member.BaseType == UBMT_INT32 && Member.NumColumns == 2)
		{
			const int64_t X = ReadMember<int32>(Pass, Member, 0);
			const int64_t Y = ReadMember<int32>(Pass, Member, 1);
			PerPixel += (2 * X + 1) * (2 * Y + 1);
		}
	}
	return PerPixel > 0 ? std::optional(static_cast<uint64_t>(PerPixel) * CountWantedPixels(Pass, Counters))
						: std::nullopt;
}

std::optional<FIntRect> FindOutputRect(const FRDGPass& Pass)
{
	if (Pass.GetParameters() == nullptr || Pass.GetParametersMetadata() == nullptr)
	{
		return std::nullopt;
	}
	FIntRect Rect;
	for (const FHlslMember& Member : Pass.GetParametersMetadata()->GetHlslMembers())
	{
		const bool bMin = Member.Name == "Output_ViewportMin";
		if ((bMin || Member.Name == "Output_ViewportMax") && Member.BaseType == UBMT_INT32 && Member.NumColumns == 2)
		{
			(bMin ? Rect.Min : Rect.Max) =
				FIntPoint(ReadMember<int32>(Pass, Member, 0), ReadMember<int32>(Pass, Member, 1));
		}
	}
	return Rect.Width() > 0 && Rect.Height() > 0 ? std::optional(Rect) : std::nullopt;
}

uint64_t CountWantedPixels(const FRDGPass& Pass, const FPassCounters& Counters)
{
	const std::optional<FIntRect> Rect = FindOutputRect(Pass);
	return Rect ? std::min(Counters.Pixels, uint64_t(Rect->Width()) * uint64_t(Rect->Height())) : Counters.Pixels;
}

} // namespace Drydock
