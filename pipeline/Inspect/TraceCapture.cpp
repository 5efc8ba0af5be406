// Runs the interpreter beside a pass.
#include "Inspect/TraceCapture.h"

#include "Diagnostics.h"
#include "PixelFormatConversion.h"
#include "Sandbox.h"
#include "TexelWriter.h"
#include "Text/ConfigErrors.h"
#include "TileExecutor.h"
#include "RangeTools.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

std::array<double, 4> ReadTexel(const FKernelTexture& Texture, int32_t X, int32_t Y)
{
	const FKernelMip& Mip = Texture.Mips[0];
	std::array<double, 4> Color{};
	if (X >= 0 && Y >= 0 && X < Mip.SizeX && Y < Mip.SizeY)
	{
		DecodeTexel(Texture.Storage,
			Mip.Data + int64_t(Y) * Mip.RowPitch + int64_t(X) * GetTexelStorageInfo(Texture.Storage).BytesPerTexel,
			Color.data());
	}
	return Color;
}

bool Part(double Float, double Double, double Bound)
{
	if (std::isnan(Float) || std::isnan(Double))
	{
		return std::isnan(Float) != std::isnan(Double);
	}
	const double Size = std::max({1.0, std::fabs(Float), std::fabs(Double)});
	return Float != Double && !(std::fabs(Float - Double) <= Bound * Size);
}

} // namespace

FTraceCapture::FTraceCapture(FTraceRequest InRequest)
	: Request(std::move(InRequest))
{
}

FTraceCapture::~FTraceCapture() = default;

void FTraceCapture::BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole)
{
	const std::string Pass = GetPassName(Shader);
	Passes.push_back(Pass);
	bTracing = false;
	if (!IsPassNamed(Request.Pass, Shader))
	{
		return;
	}
	const bool bCompute = Args.NumTargets == 0 && Shader.GetReflection().Stage == EShaderStage::Compute;
	const std::shared_ptr<FInspectedShader> Inspected = Shaders.Get(Shader);
	std::string Stored;
	std::array<int32_t, 3> Thread = Request.At;
	try
	{
		for (size_t Slot = 0; bCompute && !Request.bThread && Slot < Shader.RWTextures.size() && Stored.empty(); ++Slot)
		{
			if (const std::optional<FTexelWriter> Writer = FindTexelWriter(
					*Inspected, Shader, Args, Whole, Shader.GetReflection().RWTextures[Slot].Name, Request.At))
			{
				Stored = Writer->Texture;
				Thread = Writer->Thread;
			}
		}
	}
	catch (const FSpirvError& Error)
	{
		throw FError({ESeverity::Error, 6020, Error.what(), Error.File, Error.Line, 0, "pass " + Pass}, ExitUsage);
	}
	const auto [X, Y, Z] = Thread;
	if (bCompute && !Request.bThread && Stored.empty())
	{
		Outside.push_back(
			Pass + (Shader.RWTextures.empty() ? ": stores to no texture; --thread X,Y,Z takes the id of a thread"
											  : ": no thread of it stores there"));
		return;
	}
	if (X < Whole.MinX || Y < Whole.MinY || Z < Whole.MinZ || X >= Whole.MaxX || Y >= Whole.MaxY || Z >= Whole.MaxZ)
	{
		Outside.push_back(Pass + ": from (" + std::to_string(Whole.MinX) + ", " + std::to_string(Whole.MinY) +
						  ") to (" + std::to_string(Whole.MaxX - 1) + ", " + std::to_string(Whole.MaxY - 1) + ")");
		return;
	}
	bTracing = true;
	FCapturedTrace& Trace = Traces.emplace_back();
	Trace.Pass = Pass;
	Trace.Shader = Shader.Name;
	Trace.Entry = Shader.EntryPoint;
	Trace.Inspected = Inspected;
	Trace.Thread = Thread;
	Trace.Stored = Stored;
	for (const bool bDouble : {false, true})
	{
		const FSandbox Sandbox(Args, Shader.GetReflection());
		const FScopedDenormals Denormals(bDouble ? EDenormals::Keep : EDenormals::Flush);
		try
		{
			(bDouble ? Trace.Double : Trace.Float) =
				TracePixel(*Inspected, Sandbox.GetArgs(), {X, Y, Z}, bDouble, Request.MaxSteps);
		}
		catch (const FSpirvError& Error)
		{
			throw FError({ESeverity::Error, 6020, Error.what(), Error.File, Error.Line, 0, "pass " + Pass}, ExitUsage);
		}
	}
	Trace.Difference = FindDifference(Trace.Float, Trace.Double, Request.Bound);
}

void FTraceCapture::AfterDispatch(const FBoundShader&, const FKernelArgs& Args, const FKernelTile&)
{
	for (int32_t Index = 0; bTracing && Index < Args.NumTargets; ++Index)
	{
		Traces.back().Written.push_back(ReadTexel(Args.Targets[Index].Texture, Request.At[0], Request.At[1]));
	}
}

const std::vector<FCapturedTrace>& FTraceCapture::GetTraces() const
{
	if (!Traces.empty())
	{
		return Traces;
	}
	std::string Message;
	if (!Outside.empty())
	{
		Message = (Request.bThread ? "thread " : "pixel ") + std::to_string(Request.At[0]) + "," +
				  std::to_string(Request.At[1]) + " is outside of what the pass " +
				  (Request.bThread ? "runs" : "draws");
		for (const std::string& Name : Outside)
		{
			Message += (&Name == &Outside.front() ? ": " : "; ") + Name;
		}
	}
	else
	{
		// Behind the first word of a pass's name stands mostly its size.
		auto Words =
			ToVector<std::string>(Passes, [&](const std::string& Name) { return Name.substr(0, Name.find(' ')); });
		const std::string Nearest = FindNearestName(Request.Pass, Words);
		Message = "no pass of this run that a shader draws is called '" + Request.Pass + "'" +
				  (Nearest.empty() ? std::string(".") : "; did you mean '" + Nearest + "'?") + " There are";
		const std::set<std::string> Names(Passes.begin(), Passes.end());
		for (const std::string& Name : Names)
		{
			Message += (Name == *Names.begin() ? ": " : ", ") + Name;
		}
	}
	throw BadArgument(Message, Outside.empty() ? "--pass" : Request.bThread ? "--thread" : "--pixel");
}

std::optional<FTraceDifference> FindDifference(const FPixelTrace& Float, const FPixelTrace& Double, double Bound)
{
	for (size_t Line = 0; Line < Float.Lines.size(); ++Line)
	{
		const FTraceLine& A = Float.Lines[Line];
		const bool bSameLine = Line < Double.Lines.size() && Double.Lines[Line].Line == A.Line &&
							   Double.Lines[Line].File == A.File && Double.Lines[Line].Depth == A.Depth;
		if (!bSameLine)
		{
			return FTraceDifference{Line, 0, 0, 0, true};
		}
		const FTraceLine& B = Double.Lines[Line];
		for (size_t Event = 0; Event < A.Events.size() && Event < B.Events.size(); ++Event)
		{
			const std::vector<double>& X = A.Events[Event].Value.Reals;
			const std::vector<double>& Y = B.Events[Event].Value.Reals;
			for (size_t i = 0; i < X.size() && i < Y.size(); ++i)
			{
				if (Part(X[i], Y[i], Bound))
				{
					return FTraceDifference{Line, Event, X[i], Y[i], false};
				}
			}
		}
	}
	return std::nullopt;
}

} // namespace Drydock
