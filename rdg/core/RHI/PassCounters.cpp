// Keeps what a pass wrote and said.
#include "PassCounters.h"

#include "DiagnosticList.h"

#include <algorithm>

namespace Drydock
{

void FPassCounters::AddWrite(const FRHITexture* Texture, int32_t Mip, const FIntRect& Rect)
{
	const auto Known = std::find_if(Writes.begin(), Writes.end(),
		[&](const FTextureWrite& Write) { return Write.Texture == Texture && Write.Mip == Mip; });
	if (Known == Writes.end())
	{
		Writes.push_back({Texture, Mip, Rect});
	}
	else
	{
		Known->Rect.Union(Rect);
	}
}

std::string DescribeShaderRun(EShaderRun Ran)
{
	constexpr std::pair<EShaderRun, const char*> Names[] = {{EShaderRun::NativeKernel, "native kernel"},
		{EShaderRun::Shader, "shader"}, {EShaderRun::Interpreter, "interpreter"}, {EShaderRun::Backend, "Vulkan"}};
	std::string Text;
	for (const auto& [Flag, Name] : Names)
	{
		Text += EnumHasAnyFlags(Ran, Flag) ? (Text.empty() ? "" : ", ") + std::string(Name) : "";
	}
	return Text;
}

void FPassCounters::AddRemark(const FDiagnostic& Remark)
{
	AddNewDiagnostics(Remarks, {Remark});
}

void FPassCounters::Rename(const FRHITexture* From, const FRHITexture* To)
{
	for (FTextureWrite& Write : Writes)
	{
		Write.Texture = Write.Texture == From ? To : Write.Texture;
	}
}

} // namespace Drydock
