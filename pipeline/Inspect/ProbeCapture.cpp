// Looks at one place of every picture that a run makes.
#include "Inspect/ProbeCapture.h"

#include "Diagnostics.h"
#include "PixelFormatConversion.h"
#include "Inspect/DispatchShaders.h"
#include "RunningCode.h"
#include "RangeTools.h"
#include "Sandbox.h"
#include "Shader.h"
#include "ShaderCompilation.h"
#include "Text/GlobPattern.h"
#include "TileExecutor.h"
#include "TraceRecorder.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <tuple>

namespace Drydock
{

namespace
{

constexpr uint64_t MaxSteps = 1'000'000'000;

bool AreSame(const FProbeWrite& A, const FProbeWrite& B)
{
	return A.Target == B.Target && A.Format == B.Format && A.X == B.X && A.Y == B.Y &&
		   std::memcmp(A.Value.data(), B.Value.data(), sizeof(A.Value)) == 0;
}

/** Reads of one texture, summed up over the samples of a trace. */
void AddReadsOf(const FPixelTrace& Trace, std::vector<FProbeRead>& Reads)
{
	for (const FTraceLine& Line : Trace.Lines)
	{
		for (const FTraceEvent& Event : Line.Events)
		{
			// A sample without texels is of a texture that the kernel does not read: nothing comes of it.
			const bool bTexture = (Event.Kind == ETraceEvent::Sample && !Event.Texels.empty()) ||
								  (Event.Kind == ETraceEvent::Load && Event.Texel.size() > 1 && !Event.bShared);
			if (!bTexture)
			{
				continue;
			}
			auto Read = std::ranges::find(Reads, Event.Name, &FProbeRead::Texture);
			if (Read == Reads.end())
			{
				Read = Reads.insert(Reads.end(), FProbeRead());
				Read->Texture = Event.Name;
			}
			++Read->NumReads;
			std::vector<FFootprintTexel> Texels = Event.Texels;
			if (Event.Kind == ETraceEvent::Load)
			{
				FFootprintTexel& Texel = Texels.emplace_back();
				Texel.X = int32_t(Event.Texel[0]);
				Texel.Y = int32_t(Event.Texel[1]);
				Texel.Z = Event.Texel.size() > 2 ? int32_t(Event.Texel[2]) : 0;
				Texel.Weight = 1;
				std::copy_n(Event.Value.Reals.begin(), std::min<size_t>(4, Event.Value.Reals.size()), Texel.Value);
			}
			for (const FFootprintTexel& Texel : Texels)
			{
				const auto Key = [](const FFootprintTexel& T)
				{
					return std::tuple(T.Mip, T.Z, T.Y, T.X);
				};
				const auto Known = std::ranges::find_if(
					Read->Texels, [&](const FFootprintTexel& Other) { return Key(Other) == Key(Texel); });
				if (Known == Read->Texels.end())
				{
					Read->Texels.push_back(Texel);
				}
				else
				{
					Known->Weight += Texel.Weight;
				}
			}
		}
	}
}

void AddSharedOf(const FPixelTrace& Trace, std::vector<FProbeShared>& Shared)
{
	for (const FTraceLine& Line : Trace.Lines)
	{
		for (const FTraceEvent& Event : Line.Events)
		{
			const std::string Name =
				Event.Texel.empty() ? Event.Name : Event.Name + "[" + std::to_string(Event.Texel[0]) + "]";
			const bool bKnown = std::ranges::any_of(Shared, [&](const FProbeShared& Other)
				{ return Other.Name == Name && Other.Writer == Event.Writer && Other.WriterLine == Event.WriterLine; });
			if (Event.bShared && !bKnown)
			{
				Shared.push_back({Name, Event.Value.Reals, Event.Writer, Event.WriterLine});
			}
		}
	}
}

void ReadTexel(const FKernelTexture& Texture, const std::array<int32_t, 2>& At, FProbeTexel& Texel)
{
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Texture.Storage);
	const FKernelMip& Mip = Texture.Mips[0];
	Texel.Format = Info.Name;
	Texel.NumChannels = Info.NumChannels;
	Texel.X = At[0];
	Texel.Y = At[1];
	const uint8_t* const Address = Mip.Data + int64_t(Texel.Y) * Mip.RowPitch + int64_t(Texel.X) * Info.BytesPerTexel;
	DecodeTexel(Texture.Storage, Address, Texel.Value.data());
}

/** A volume has no pixel. */
bool HasPixels(const FKernelTexture& Texture)
{
	return Texture.NumMips > 0 && Texture.Mips[0].SizeZ <= 1;
}

/** The texture that the shader calls so, or null. */
const FKernelTexture* FindTexture(
	const std::string& Name, const std::vector<FShaderResource>& Resources, const std::vector<FKernelTexture>& Textures)
{
	const auto Found = std::find_if(
		Resources.begin(), Resources.end(), [&Name](const FShaderResource& Resource) { return Resource.Name == Name; });
	return Found == Resources.end() ? nullptr : &Textures[size_t(Found - Resources.begin())];
}

} // namespace

FProbeCapture::FProbeCapture(FProbeRequest InRequest)
	: Request(std::move(InRequest))
{
}

FProbeCapture::~FProbeCapture() = default;

std::array<int32_t, 2> FProbeCapture::Map(int32_t X, int32_t Y, int32_t SizeX, int32_t SizeY) const
{
	const auto Axis = [](int32_t At, int32_t Frame, int32_t Size)
	{
		const int64_t Mapped = Frame > 0 ? (2 * int64_t(At) + 1) * Size / (2 * int64_t(Frame)) : At;
		return int32_t(std::clamp<int64_t>(Mapped, 0, std::max(0, Size - 1)));
	};
	return {Axis(X, Request.Frame[0], SizeX), Axis(Y, Request.Frame[1], SizeY)};
}

void FProbeCapture::AddReads(
	const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole, FProbePass& Pass)
{
	const std::shared_ptr<FInspectedShader> Inspected = Shaders.Get(Shader);
	std::vector<std::array<int32_t, 3>> Threads;
	if (Args.NumTargets > 0)
	{
		const FKernelMip& Mip = Args.Targets[0].Texture.Mips[0];
		const std::array<int32_t, 2> At = Map(Request.X, Request.Y, Mip.SizeX, Mip.SizeY);
		if (At[0] >= Whole.MinX && At[1] >= Whole.MinY && At[0] < Whole.MaxX && At[1] < Whole.MaxY)
		{
			Threads.push_back({At[0], At[1], Whole.MinZ});
		}
	}
	bool bPictures = Args.NumTargets > 0;
	const FScopedDenormals Denormals(EDenormals::Flush);
	try
	{
		for (size_t Slot = 0; Slot < Shader.RWTextures.size(); ++Slot)
		{
			const FKernelTexture& Texture = Shader.RWTextures[Slot];
			if (Args.NumTargets > 0 || !HasPixels(Texture))
			{
				continue;
			}
			bPictures = true;
			const std::array<int32_t, 2> At = Map(Request.X, Request.Y, Texture.Mips[0].SizeX, Texture.Mips[0].SizeY);
			if (const std::optional<FTexelWriter> Writer = FindTexelWriter(
					*Inspected, Shader, Args, Whole, Shader.GetReflection().RWTextures[Slot].Name, {At[0], At[1], 0}))
			{
				Pass.Threads.push_back(*Writer);
				AddUnique(Threads, Writer->Thread);
			}
		}
		Pass.bDrawn = !bPictures || !Threads.empty();
		for (const std::array<int32_t, 3>& Thread : Threads)
		{
			const FSandbox Sandbox(Args, Shader.GetReflection());
			const FPixelTrace Trace =
				TracePixel(*Inspected, Sandbox.GetArgs(), {Thread[0], Thread[1], Thread[2]}, false, MaxSteps);
			AddReadsOf(Trace, Pass.Reads);
			AddSharedOf(Trace, Pass.Shared);
		}
	}
	catch (const FSpirvError& Error)
	{
		throw FError({ESeverity::Error, 6020, Error.what(), Error.File, Error.Line, 0, "pass " + Pass.Pass}, ExitUsage);
	}
	for (FProbeRead& Read : Pass.Reads)
	{
		AddTexel(Shader, Read);
	}
}

void FProbeCapture::AddTexel(const FBoundShader& Shader, FProbeRead& Read) const
{
	const FShaderReflection& Reflection = Shader.GetReflection();
	const FKernelTexture* Texture = FindTexture(Read.Texture, Reflection.Textures, Shader.Textures);
	Texture = Texture ? Texture : FindTexture(Read.Texture, Reflection.RWTextures, Shader.RWTextures);
	if (Texture && HasPixels(*Texture))
	{
		Read.Size = {Texture->Mips[0].SizeX, Texture->Mips[0].SizeY};
		ReadTexel(*Texture, Map(Request.X, Request.Y, Read.Size[0], Read.Size[1]), Read.AtPixel.emplace());
	}
}

void FProbeCapture::BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole)
{
	const std::string Name = GetPassName(Shader);
	bProbing = IsPassNamed(Request.Passes, Shader);
	if (bProbing)
	{
		Passes.push_back({Name, Shader.Name, true, {}, {}, {}, {}});
		AddReads(Shader, Args, Whole, Passes.back());
	}
}

void FProbeCapture::AddWrites(const std::string& Name, const FKernelTexture& Texture, FProbePass& Pass) const
{
	if (!HasPixels(Texture))
	{
		return;
	}
	const FKernelMip& Mip = Texture.Mips[0];
	std::set<std::array<int32_t, 2>> Seen; // y, x: a smaller picture has one texel for several pixels
	for (int32_t y = 0; y < Request.Height; ++y)
	{
		for (int32_t x = 0; x < Request.Width; ++x)
		{
			const std::array<int32_t, 2> At = Map(Request.X + x, Request.Y + y, Mip.SizeX, Mip.SizeY);
			Seen.insert({At[1], At[0]});
		}
	}
	for (const std::array<int32_t, 2>& At : Seen)
	{
		FProbeWrite& Write = Pass.Writes.emplace_back();
		Write.Target = Name;
		ReadTexel(Texture, {At[1], At[0]}, Write);
	}
}

void FProbeCapture::AfterDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile&)
{
	for (int32_t Target = 0; bProbing && Target < Args.NumTargets; ++Target)
	{
		AddWrites("SV_Target" + std::to_string(Target), Args.Targets[Target].Texture, Passes.back());
	}
	for (size_t Slot = 0; bProbing && Slot < Shader.RWTextures.size(); ++Slot)
	{
		AddWrites(Shader.GetReflection().RWTextures[Slot].Name, Shader.RWTextures[Slot], Passes.back());
	}
}

std::optional<FProbeDifference> FindDifference(const std::vector<FProbePass>& A, const std::vector<FProbePass>& B)
{
	for (size_t Pass = 0; Pass < A.size() || Pass < B.size(); ++Pass)
	{
		if (Pass >= A.size() || Pass >= B.size() || A[Pass].Pass != B[Pass].Pass || A[Pass].Shader != B[Pass].Shader ||
			A[Pass].Writes.size() != B[Pass].Writes.size())
		{
			return FProbeDifference{Pass, 0, true};
		}
		for (size_t Write = 0; Write < A[Pass].Writes.size(); ++Write)
		{
			if (!AreSame(A[Pass].Writes[Write], B[Pass].Writes[Write]))
			{
				return FProbeDifference{Pass, Write, false};
			}
		}
	}
	return std::nullopt;
}

} // namespace Drydock
