// Reads numbers out of a pass's parameter struct by its metadata.
#include "Run/PassValues.h"

#include "RenderGraphPass.h"
#include "ShaderParameterMetadata.h"
#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"
#include "TextTools.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

namespace
{

/** True for parameters of a viewport that follow from Extent, ViewportMin and ViewportMax. */
bool FollowsFromViewport(const std::string& Name)
{
	constexpr const char* Derived[] = {".ExtentInverse", ".ScreenPosToViewportScale", ".ScreenPosToViewportBias",
		".ViewportSize", ".ViewportSizeInverse", ".UVViewportMin", ".UVViewportMax", ".UVViewportSize",
		".UVViewportSizeInverse", ".UVViewportBilinearMin", ".UVViewportBilinearMax"};
	return std::ranges::any_of(Derived, [&Name](const char* Ending) { return Name.ends_with(Ending); });
}

template<typename T>
T ReadNumber(const char* Address)
{
	T Number;
	std::memcpy(&Number, Address, sizeof(Number));
	return Number;
}

std::string FormatNumber(EUniformBufferBaseType Type, const char* Address)
{
	return Type == UBMT_FLOAT32  ? NumberText(ReadNumber<float>(Address))
		   : Type == UBMT_UINT32 ? std::to_string(ReadNumber<uint32>(Address))
								 : std::to_string(ReadNumber<int32>(Address));
}

std::string FormatMember(const FHlslMember& Member, const char* Address)
{
	if (Member.NumElements > 0)
	{
		return std::to_string(Member.NumElements) + " of " + Member.Type;
	}
	constexpr size_t NumberBytes = 4;
	const size_t Count = size_t(std::max(Member.NumRows, 1u)) * std::max(Member.NumColumns, 1u);
	std::string Text;
	for (size_t Index = 0; Index < Count; ++Index)
	{
		Text += (Index > 0 ? ", " : "") + FormatNumber(Member.BaseType, Address + Index * NumberBytes);
	}
	return Count > 1 ? "(" + Text + ")" : Text;
}

} // namespace

std::vector<FPassValue> ReadPassValues(const FRDGPass& Pass)
{
	std::vector<FPassValue> Values;
	if (Pass.GetParameters() == nullptr || Pass.GetParametersMetadata() == nullptr)
	{
		return Values;
	}
	for (const FHlslMember& Member : Pass.GetParametersMetadata()->GetHlslMembers())
	{
		if (Member.IsConstant() && !FollowsFromViewport(Member.CodeName))
		{
			const char* const Address = static_cast<const char*>(Pass.GetParameters()) + Member.Offset;
			const std::string Array = Member.NumElements > 0 ? "[" + std::to_string(Member.NumElements) + "]" : "";
			Values.push_back({Member.CodeName, Member.Type + Array, FormatMember(Member, Address)});
		}
	}
	return Values;
}

std::string FormatPassValues(const std::vector<FPassValue>& Values)
{
	return JoinText(Values, ", ", [&](const FPassValue& Value) { return Value.Name + " = " + Value.Value; });
}

void WriteValues(FJsonWriter& Writer, const std::vector<FPassValue>& Values)
{
	Writer.Object("values", Values, [&](const FPassValue& Value) { Writer.Member(Value.Name, Value.Value); });
}

} // namespace Drydock
