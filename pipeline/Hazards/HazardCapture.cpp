// Runs a pass's kernel on hazards and looks at what it wrote.
#include "Hazards/HazardCapture.h"

#include "Diagnostics.h"
#include "Hazards/HazardPictures.h"
#include "KernelRerun.h"
#include "PixelFormatConversion.h"
#include "Run/RunDump.h"
#include "RunningCode.h"
#include "Text/ConfigErrors.h"
#include "Text/GlobPattern.h"
#include "Text/TextFormat.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>

namespace Drydock
{

namespace
{

void WriteImage(const FImage& Image, const FKernelTexture& Texture)
{
	const int32_t TexelBytes = GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
	for (int y = 0; y < Image.Height; ++y)
	{
		for (int x = 0; x < Image.Width; ++x)
		{
			const double Color[4] = {Image.Get(x, y, 0), Image.Get(x, y, 1), Image.Get(x, y, 2), Image.Get(x, y, 3)};
			EncodeTexel(Texture.Storage, Color, GetTexelAddress(Texture.Mips[0], x, y, TexelBytes),
				Texture.bSaturateStore != 0);
		}
	}
}

FImage ReadImage(const FKernelTexture& Texture)
{
	const FKernelMip& Mip = Texture.Mips[0];
	const int32_t TexelBytes = GetTexelStorageInfo(Texture.Storage).BytesPerTexel;
	FImage Image{Mip.SizeX, Mip.SizeY, 4, {}};
	for (int32_t y = 0; y < Mip.SizeY; ++y)
	{
		for (int32_t x = 0; x < Mip.SizeX; ++x)
		{
			double Color[4];
			DecodeTexel(Texture.Storage, Mip.Data + int64_t(y) * Mip.RowPitch + int64_t(x) * TexelBytes, Color);
			Image.Values.insert(Image.Values.end(), Color, Color + 4);
		}
	}
	return Image;
}

bool IsColorTexture(const FKernelTexture& Texture)
{
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Texture.Storage);
	return Texture.NumMips > 0 && !Texture.bIs3D && Texture.Mips[0].SizeZ == 1 && Info.Kind != ETexelKind::Uint &&
		   Info.NumChannels >= 3;
}

/** True for a constant of the pass's own struct that is not a place or size. */
bool IsTunable(const FShaderReflection& Reflection, const FShaderConstant& Constant)
{
	const std::string& Name = Constant.Name;
	const auto Has = [&Name](const char* Word)
	{
		return Name.find(Word) != std::string::npos;
	};
	const bool bPlace = Has("Viewport") || Has("Extent") || Has("Size") || Has("UV") || Has("Rect") || Has("Position");
	return Reflection.ConstantBuffers[Constant.Buffer].Name == "$Global" && Constant.bUsed && !bPlace &&
		   Constant.Scalar == EShaderScalar::Float && Constant.Rows == 1 && Constant.NumElements == 0;
}

/** The picture or constant that one run gets in place of the frame's own. */
struct FReplaced
{
	size_t Slot = 0;
	const FImage* Picture = nullptr;
	bool bFloat32 = false;
	const FShaderConstant* Constant = nullptr;
	float Value = 0.0f;
};

class FPassRunner
{
public:
	FPassRunner(const FBoundShader& InShader, const FKernelArgs& InArgs, const FKernelTile& InWhole)
		: Shader(InShader)
		, FrameArgs(InArgs)
		, Whole(InWhole)
	{
	}

	/** The first render target, or texture that a compute shader stores to. */
	FImage Run(const FReplaced& Replaced) const
	{
		FKernelRerun Rerun(Shader, FrameArgs, Whole);
		WriteImage(*Replaced.Picture, (Replaced.bFloat32 ? Rerun.OwnInput(Replaced.Slot, ETexelStorage::RGBA32_FLOAT)
														 : Rerun.OwnInput(Replaced.Slot))
										  .Get());
		if (Replaced.Constant)
		{
			Rerun.SetConstant(*Replaced.Constant, Replaced.Value);
		}
		Rerun.Run();
		return ReadImage(Rerun.GetWritten()[0]);
	}

private:
	const FBoundShader& Shader;
	const FKernelArgs& FrameArgs;
	const FKernelTile& Whole;
};

/** A pixel of the texture that a pass writes. */
struct FPlace
{
	int X = 0;
	int Y = 0;
};

void LookAt(const FImage& Clean, const FKernelTile& Drawn, const std::optional<FPlace>& Bad, FHazardFinding& Finding)
{
	const FImage& Result = Finding.Result;
	const int MaxX = std::min(Drawn.MaxX, Result.Width), MaxY = std::min(Drawn.MaxY, Result.Height);
	Finding.Least = std::numeric_limits<double>::infinity();
	Finding.Most = -Finding.Least;
	Finding.bFlat = true;
	for (int Y = Drawn.MinY; Y < MaxY; ++Y)
	{
		for (int X = Drawn.MinX; X < MaxX; ++X)
		{
			bool bNaN = false, bInfinite = false, bNegative = false, bChanged = false;
			for (int Channel = 0; Channel < 4; ++Channel)
			{
				const double Value = Result.Get(X, Y, Channel), Other = Clean.Get(X, Y, Channel);
				bNaN = bNaN || std::isnan(Value);
				bInfinite = bInfinite || std::isinf(Value);
				bNegative = bNegative || (Channel < 3 && Value < 0);
				bChanged = bChanged || !(Value == Other || (std::isnan(Value) && std::isnan(Other)));
				Finding.bFlat = Finding.bFlat && Value == Result.Get(Drawn.MinX, Drawn.MinY, Channel);
				if (Channel < 3 && std::isfinite(Value))
				{
					Finding.Least = std::min(Finding.Least, Value);
					Finding.Most = std::max(Finding.Most, Value);
				}
			}
			++Finding.NumPixels;
			Finding.NumNaN += bNaN;
			Finding.NumInfinite += bInfinite;
			Finding.NumNegative += bNegative;
			Finding.NumChanged += bChanged;
			if (bChanged && Bad)
			{
				Finding.Reach = std::max({Finding.Reach, std::abs(X - Bad->X), std::abs(Y - Bad->Y)});
			}
		}
	}
}

bool AreEqual(const FImage& A, const FImage& B, const FKernelTile& Drawn)
{
	bool bEqual = A.Width == B.Width && A.Height == B.Height;
	for (int Y = Drawn.MinY; bEqual && Y < std::min(Drawn.MaxY, A.Height); ++Y)
	{
		for (int X = Drawn.MinX; bEqual && X < std::min(Drawn.MaxX, A.Width); ++X)
		{
			for (int Channel = 0; Channel < 4; ++Channel)
			{
				const double ValueA = A.Get(X, Y, Channel), ValueB = B.Get(X, Y, Channel);
				bEqual = bEqual && std::memcmp(&ValueA, &ValueB, sizeof(double)) == 0;
			}
		}
	}
	return bEqual;
}

using FColor3 = std::array<double, 3>;

/** One pixel that is not as the others: the clean picture is another. */
bool HasBadPixel(EHazard Hazard)
{
	return Hazard <= EHazard::MinusInf || Hazard == EHazard::Huge || Hazard == EHazard::HotPixel ||
		   Hazard == EHazard::BeyondHalf;
}

std::string MakeFileName(std::string Name)
{
	std::replace_if(
		Name.begin(), Name.end(), [](unsigned char Letter) { return !std::isalnum(Letter) && Letter != '.'; }, '_');
	return Name;
}

} // namespace

FHazardCapture::FHazardCapture(FHazardRequest InRequest)
	: Request(std::move(InRequest))
{
}

FHazardCapture::~FHazardCapture() = default;

void FHazardCapture::BeforeDispatch(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole)
{
	const FCodeOwner* const Owner = GetRunningCode();
	const std::string Name = Owner && !Owner->Pass.empty() ? Owner->Pass : Shader.Name;
	Passes.push_back(Name);
	const bool bOfPlugin = Owner != nullptr && !Owner->Plugin.empty();
	bPluginRan = bPluginRan || bOfPlugin;
	if (Request.Pass.empty() ? !bOfPlugin
							 : !IsPassNamed(Request.Pass, Name) && !MatchesPattern(Request.Pass, Shader.Name))
	{
		return;
	}
	const FShaderReflection& Reflection = Shader.GetReflection();
	size_t Slot = Shader.Textures.size();
	for (size_t Index = Shader.Textures.size(); Index-- > 0;)
	{
		const std::string& Texture = Reflection.Textures[Index].Name;
		if (IsColorTexture(Shader.Textures[Index]))
		{
			Inputs.push_back(Texture);
			Slot = Request.Input.empty() || Request.Input == Texture ? Index : Slot;
		}
	}
	const bool bWrites = Args.NumTargets > 0 || (!Shader.RWTextures.empty() && Shader.RWTextures[0].NumMips > 0);
	if (Slot == Shader.Textures.size() || !bWrites)
	{
		return;
	}
	const FKernelMip& Mip = Shader.Textures[Slot].Mips[0];
	FHazardRow Row{Name, Shader.Name, Reflection.Textures[Slot].Name, Mip.SizeX, Mip.SizeY, {}, {}};
	const FPassRunner Runner(Shader, Args, Whole);
	const int32_t OutputX =
		Args.NumTargets > 0 ? Args.Targets[0].Texture.Mips[0].SizeX : Shader.RWTextures[0].Mips[0].SizeX;
	const int32_t OutputY =
		Args.NumTargets > 0 ? Args.Targets[0].Texture.Mips[0].SizeY : Shader.RWTextures[0].Mips[0].SizeY;
	const FPlace BadResult{(Whole.MinX + Whole.MaxX) / 2, (Whole.MinY + Whole.MaxY) / 2};
	const FPlace Bad{std::clamp(BadResult.X * Mip.SizeX / OutputX, 0, std::max(0, Mip.SizeX - 2)),
		std::clamp(BadResult.Y * Mip.SizeY / OutputY, 0, Mip.SizeY - 1)};
	const auto Add = [&](const std::string& Hazard, const FReplaced& Replaced, const FImage& Clean, bool bBadPixel)
	{
		FHazardFinding& Finding = Row.Findings.emplace_back();
		Finding.Hazard = Hazard;
		Finding.File = MakeFileName(Hazard);
		Finding.Result = Runner.Run(Replaced);
		LookAt(Clean, Whole, bBadPixel ? std::optional(BadResult) : std::nullopt, Finding);
		Finding.bAsInput = AreEqual(Finding.Result, *Replaced.Picture, Whole);
	};
	for (size_t Index = 0; Index < NumHazards; ++Index)
	{
		const EHazard Hazard = static_cast<EHazard>(Index);
		const bool bOnce = Hazard != EHazard::PowOfZero && Hazard != EHazard::PowOfNegative; // as black, as negative
		const std::vector<FHazardPicture> Pictures =
			bOnce && Mip.SizeX > 1 ? MakeHazardPictures(Hazard, Mip.SizeX, Mip.SizeY, Bad.X, Bad.Y)
								   : std::vector<FHazardPicture>();
		for (size_t Case = 0; Case < Pictures.size(); ++Case)
		{
			const FHazardPicture& Picture = Pictures[Case];
			const FImage Clean = Runner.Run({Slot, &Picture.Clean, Picture.bFloat32});
			Add(Hazards[Index].Title + (Pictures.size() > 1 ? " #" + std::to_string(Case + 1) : std::string()),
				{Slot, &Picture.Picture, Picture.bFloat32}, Clean, HasBadPixel(Hazard));
		}
	}
	const FImage Noise = MakeHazardNoise(Mip.SizeX, Mip.SizeY);
	const FImage Clean = Runner.Run({Slot, &Noise});
	for (const FShaderConstant& Constant : Reflection.Constants)
	{
		for (const float Value : {0.0f, -1.0f, 1e6f})
		{
			if (IsTunable(Reflection, Constant) && !Shader.Native)
			{
				Add(Constant.Name + " = " + NumberText(Value), {Slot, &Noise, false, &Constant, Value}, Clean, false);
			}
		}
	}
	for (const auto& [Tone, In] : {std::pair("grey", FColor3{0.18, 0.18, 0.18}), {"mid grey", FColor3{0.5, 0.5, 0.5}},
			 {"a colour", FColor3{0.75, 0.5, 0.25}}})
	{
		FImage Flat{Mip.SizeX, Mip.SizeY, 4, {}};
		for (int Pixel = 0; Pixel < Mip.SizeX * Mip.SizeY; ++Pixel)
		{
			Flat.Values.insert(Flat.Values.end(), In.begin(), In.end());
			Flat.Values.push_back(1.0);
		}
		const FImage Result = Runner.Run({Slot, &Flat});
		const int X = std::min(BadResult.X, Result.Width - 1), Y = std::min(BadResult.Y, Result.Height - 1);
		const FColor3 Out = {Result.Get(X, Y, 0), Result.Get(X, Y, 1), Result.Get(X, Y, 2)};
		Row.Tones.push_back({Tone, In, Out, DescribeTone(In, Out)});
	}
	Rows.push_back(std::move(Row));
}

const std::vector<FHazardRow>& FHazardCapture::GetRows() const
{
	if (!Rows.empty() || (Request.Pass.empty() && bPluginRan))
	{
		return Rows;
	}
	if (Request.Pass.empty() && !bPluginRan)
	{
		throw BadArgument("no pass of a plugin ran a shader; name a pass", "--pass");
	}
	const bool bFits = std::any_of(
		Passes.begin(), Passes.end(), [this](const std::string& Pass) { return IsPassNamed(Request.Pass, Pass); });
	const bool bInput = bFits || !Inputs.empty();
	const std::string& Wanted = bInput ? Request.Input : Request.Pass;
	const std::string Message =
		bInput ? "the pass reads no picture" + (Wanted.empty() ? std::string() : " '" + Wanted + "'")
			   : "no pass of this run that a shader draws matches '" + Wanted + "'";
	throw BadArgument(Message + SuggestName(Wanted, bInput ? Inputs : Passes), bInput ? "--input" : "--pass");
}

} // namespace Drydock
