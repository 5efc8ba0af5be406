// Finds the thread of a pass that a pixel is, and runs it beside the pass.
#include "Inspect/DebugCapture.h"

#include "Inspect/DispatchShaders.h"
#include "RunningCode.h"
#include "Sandbox.h"
#include "Shader.h"
#include "ShaderCompilation.h"
#include "Text/ConfigErrors.h"
#include "Text/GlobPattern.h"
#include "TextTools.h"
#include "TileExecutor.h"

#include <algorithm>
#include <fstream>
#include <set>

namespace Drydock
{

namespace
{

/** Whether a debugger holds this process. Source: proc(5), TracerPid. */
bool IsBeingDebugged()
{
	std::ifstream Status("/proc/self/status");
	for (std::string Line; std::getline(Status, Line);)
	{
		if (Line.starts_with("TracerPid:"))
		{
			return Line.find_first_of("123456789") != std::string::npos;
		}
	}
	return false;
}

} // namespace

FDebugCapture::FDebugCapture(FDebugRequest InRequest)
	: Request(std::move(InRequest))
{
}

FDebugCapture::~FDebugCapture() = default;

std::optional<std::array<int32_t, 3>> FDebugCapture::FindThread(
	const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) const
{
	std::array<int32_t, 3> At = Request.At;
	const bool bCompute = Shader.GetReflection().Stage == EShaderStage::Compute;
	if (Request.bThread && !bCompute)
	{
		return std::nullopt;
	}
	if (!Request.bThread)
	{
		// Pixel shaders draw the texel, compute shaders mostly write that of their own number.
		const FKernelTexture* const Picture = Args.NumTargets > 0          ? &Args.Targets[0].Texture
											  : !Shader.RWTextures.empty() ? &Shader.RWTextures[0]
																		   : nullptr;
		const int32_t Size[2] = {Picture && Picture->NumMips > 0 ? Picture->Mips[0].SizeX : Whole.MaxX,
			Picture && Picture->NumMips > 0 ? Picture->Mips[0].SizeY : Whole.MaxY};
		for (size_t Axis = 0; Axis < 2; ++Axis)
		{
			const int64_t Frame = Request.Frame[Axis];
			At[Axis] = Frame > 0 ? int32_t((2 * int64_t(At[Axis]) + 1) * Size[Axis] / (2 * Frame)) : At[Axis];
		}
		At[2] = Whole.MinZ;
	}
	const bool bInside = At[0] >= Whole.MinX && At[1] >= Whole.MinY && At[2] >= Whole.MinZ && At[0] < Whole.MaxX &&
						 At[1] < Whole.MaxY && At[2] < Whole.MaxZ;
	return bInside ? std::optional(At) : std::nullopt;
}

const FDebuggedShader* FDebugCapture::FindShader(const FBoundShader& Shader, const std::string& Pass)
{
	const auto [Found, bNew] = Shaders.try_emplace({Shader.Permutation, Shader.GetReflection().bQuads});
	if (bNew)
	{
		try
		{
			const FShaderRef Permutation(Shader.Permutation);
			Found->second = std::make_unique<FDebuggedShader>(
				MakeShaderCompileRequest(Permutation, Permutation.GetRootParametersMetadata()), Shader.GetReflection());
		}
		catch (const FError& Error)
		{
			if (Error.GetExitCode() != ExitUsage)
			{
				throw;
			}
			FDiagnostic Problem = Error.GetDiagnostics().front();
			Problem.Severity = ESeverity::Warning;
			Problem.Code = WarnDebug;
			Problem.Message = Shader.Name + " runs without the debugger: " + Problem.Message;
			Problem.Where = "pass " + Pass;
			Problems.push_back(std::move(Problem));
		}
	}
	return Found->second.get();
}

void FDebugCapture::BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole)
{
	const std::string Pass = GetPassName(Shader);
	const bool bFits = IsPassNamed(Request.Passes, Shader);
	std::optional<std::array<int32_t, 3>> At = bFits ? FindThread(Shader, Args, Whole) : std::nullopt;
	if (!At)
	{
		Others.push_back(Pass);
		return;
	}
	const FDebuggedShader* const Debugged = FindShader(Shader, Pass);
	const bool bDebugged = IsBeingDebugged();
	while (Debugged && At)
	{
		const FSandbox Sandbox(Args, Shader.GetReflection());
		const FScopedDenormals Denormals(EDenormals::Flush);
		try
		{
			Passes.push_back(
				{Pass, Shader.Name, *At, Debugged->Run(Sandbox.GetArgs(), Whole, *At, Request.MaxSteps, bDebugged)});
		}
		catch (const FSpirvError& Error)
		{
			throw FError({ESeverity::Error, 6020, Error.what(), Error.File, Error.Line, 0, "pass " + Pass}, ExitUsage);
		}
		At = Passes.back().Thread.Next;
	}
}

std::vector<FDiagnostic> FDebugCapture::GetDiagnostics() const
{
	std::vector<FDiagnostic> Diagnostics = Problems;
	if (Passes.empty() && Problems.empty())
	{
		throw BadArgument("no pass of this run draws that pixel with a shader that matches '" + Request.Passes +
							  "'. There are: " + JoinText(std::set<std::string>(Others.begin(), Others.end())),
			"--debug-shaders");
	}
	if (!IsBeingDebugged())
	{
		FDiagnostic& Nobody = Diagnostics.emplace_back();
		Nobody.Severity = ESeverity::Warning;
		Nobody.Code = WarnDebug;
		Nobody.Message = "no debugger holds this process, so nothing stopped: start it as gdb --args drydock run ...";
		Nobody.Where = "--debug-shaders";
	}
	return Diagnostics;
}

FDebugRequest MakeDebugRequest(const std::string& Pixel, const std::string& Passes, const std::array<int32_t, 2>& Frame)
{
	FDebugRequest Request;
	Request.Passes = Passes;
	Request.Frame = Frame;
	const std::vector<int32_t> Numbers = ParseList<int32_t>(Pixel);
	const bool bGood = Numbers.size() == 2 || Numbers.size() == 3;
	std::copy_n(Numbers.begin(), bGood ? Numbers.size() : 0, Request.At.begin());
	Request.bThread = Numbers.size() == 3;
	const auto [X, Y, Z] = Request.At;
	const bool bInside = X >= 0 && Y >= 0 && Z >= 0 && (Request.bThread || !Frame[0] || (X < Frame[0] && Y < Frame[1]));
	if (!bGood || !bInside)
	{
		const std::string Size = std::to_string(Frame[0]) + " x " + std::to_string(Frame[1]);
		throw BadArgument("'" + Pixel + "' is not a pixel of the frame, which is " + Size +
							  "; expected X,Y as in 100,50, or X,Y,Z of a compute thread",
			"--debug-shaders");
	}
	return Request;
}

} // namespace Drydock
