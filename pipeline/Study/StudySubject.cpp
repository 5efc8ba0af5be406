// Runs a blur of an image, or a frame of a config, with what a study sets.
#include "Study/StudySubject.h"

#include "Budget/StudyRequest.h"
#include "Math/ToInteger.h"
#include "Run/Run.h"
#include "SceneFile/SceneCache.h"
#include "Run/RunDump.h"
#include "Study/BlurAlgorithms.h"
#include "Study/BlurExact.h"
#include "Text/Fmt.inl"
#include "Toon/ToonShadowBlur.h"

#include <chrono>
#include <cmath>
#include <map>
#include <numbers>

namespace Drydock
{

namespace
{

// Blurs -------------------------------------------------------------------------------------------------------------

FImage LoadSceneColor(const FConfig& Config)
{
	if (!Config.Scene.File.IsSet())
	{
		throw MakeStudyError(ErrorMissingKey, Config, {}, "a study of blurs needs \"scene\", the picture to blur");
	}
	FImageFile File(Config.Resolve(Config.Scene.File.Value), EImageExtent::Display);
	std::vector<int> Indices;
	for (const char* Name : {"R", "G", "B"})
	{
		const auto Mapped = Config.Scene.Channels.find(Name);
		const int Index = File.FindChannel(Mapped == Config.Scene.Channels.end() ? Name : Mapped->second.Value);
		if (Index < 0)
		{
			throw MakeStudyError(ErrorChannelMissing, Config, Config.Scene.File.Place,
				std::string("the scene file has no channel ") + Name + ", which a study of blurs needs");
		}
		Indices.push_back(Index);
	}
	const std::vector<std::vector<float>> Planes = File.Read(Indices);
	FImage Image{File.GetWidth(), File.GetHeight(), 4, {}};
	Image.Values.reserve(Planes[0].size() * 4);
	for (size_t Pixel = 0; Pixel < Planes[0].size(); ++Pixel)
	{
		for (const std::vector<float>& Plane : Planes)
		{
			Image.Values.push_back(static_cast<double>(Plane[Pixel]));
		}
		Image.Values.push_back(1.0);
	}
	return Image;
}

void Exclude(FStudyVariant& Variant, EStudyExclusion Exclusion, const std::string& Why)
{
	Variant.Exclusion = Exclusion;
	Variant.Excluded = Why;
}

class FBlurSubject final : public IStudySubject
{
public:
	explicit FBlurSubject(const FConfig& Config)
		: Scene(LoadSceneColor(Config))
	{
	}

	FMeasured RunReference(const FStudySet& Case) override
	{
		const auto Begin = std::chrono::steady_clock::now();
		FMeasured Measured;
		Measured.Image = BlurExact(GetInput(Case), GetSigma(Case));
		Measured.Milliseconds =
			std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Begin).count();
		Measured.Taps = GetExactTaps(GetSigma(Case));
		return Measured;
	}

	FMeasured Run(const FStudySet& Set) override
	{
		FBlurRun Run = GetBlur(Set).Run(GetInput(Set));
		return {std::move(Run.Image), EImageEncoding::Linear, Run.Milliseconds, Run.TapsPerPixel, Run.BytesPerPixel};
	}

	void Prepare(const FStudySet& Set, FStudyVariant& Variant) override
	{
		const FBlurAlgorithm& Algorithm = *FindBlurAlgorithm(GetAssigned(Set, "algorithm", "Separable"));
		const double Sigma = GetSigma(Set);
		Variant.bPlainCode = !Algorithm.bGraph;
		const bool bFixed = Variant.bPlainCode || Algorithm.Name == "FFT";
		const bool bOwnArithmetic = GetAssigned(Set, "storage", "float32") != "float32" ||
									GetAssigned(Set, "precision", "float") != "float" ||
									GetAssigned(Set, "resolution", "100") != "100";
		if (bFixed && bOwnArithmetic)
		{
			return Exclude(Variant, EStudyExclusion::NotRun,
				fmt::format("not run: {} bit at full resolution only", Variant.bPlainCode ? 64 : 32));
		}
		if (Sigma > Algorithm.LargestSigma && Algorithm.Name == "Direct")
		{
			Variant.Taps = GetDirectTaps(Sigma);
			return Exclude(Variant, EStudyExclusion::NotRun,
				fmt::format("not run: it would take {} taps per pixel", ToInteger<long>(Variant.Taps)));
		}
		const double LowSigma = Sigma * std::exp2(-GetArithmetic(Set).ResolutionLevels);
		if (LowSigma > Algorithm.LargestSigma || LowSigma < Algorithm.SmallestSigma)
		{
			return Exclude(Variant, EStudyExclusion::NotRun, "not run: it cannot be made this wide");
		}
		const FBlur& Blur = GetBlur(Set);
		Variant.MeasuredSigma = Blur.GetMeasuredSigma();
		if (!Blur.IsMatched())
		{
			Exclude(Variant, EStudyExclusion::WrongWidth,
				fmt::format("its width is {:.3g} pixels, not {:.3g}", Variant.MeasuredSigma, Sigma));
		}
	}

	std::string GetTimeKey(const FStudySet& Set) override
	{
		std::string Key;
		for (const char* Name : {"algorithm", "sigma", "storage", "precision", "resolution"})
		{
			Key += GetAssigned(Set, Name, "") + "|";
		}
		return Key;
	}

	std::string DescribeReference(const FStudySet&) override { return "exact Gaussian in double"; }

private:
	static double GetSigma(const FStudySet& Set) { return std::stod(GetAssigned(Set, "sigma", "8")); }

	static FBlurArithmetic GetArithmetic(const FStudySet& Set)
	{
		FBlurArithmetic Arithmetic;
		Arithmetic.Storage = GetAssigned(Set, "storage", "float32");
		Arithmetic.bDouble = GetAssigned(Set, "precision", "float") == "double";
		Arithmetic.ResolutionLevels =
			ToInteger<int>(std::round(-std::log2(std::stod(GetAssigned(Set, "resolution", "100")) / 100.0)));
		return Arithmetic;
	}

	FImage GetInput(const FStudySet& Set) const
	{
		return MakeBlurInput(GetAssigned(Set, "input", "scene"), Scene, GetSigma(Set));
	}

	const FBlur& GetBlur(const FStudySet& Set)
	{
		const std::string Key = GetTimeKey(Set);
		const auto Found = Blurs.find(Key);
		return Found != Blurs.end() ? Found->second
									: Blurs
										  .emplace(Key, FBlur(GetAssigned(Set, "algorithm", "Separable"), GetSigma(Set),
															GetArithmetic(Set)))
										  .first->second;
	}

	FImage Scene;
	std::map<std::string, FBlur> Blurs;
};

// Frames ------------------------------------------------------------------------------------------------------------

class FFrameSubject final : public IStudySubject
{
public:
	FFrameSubject(const FRunOptions& InOptions, const FStudy& InStudy)
		: Options(InOptions)
		, Study(InStudy)
	{
		Options.Progress = nullptr;
		Options.bUseBudget = false;
		Options.SceneCache = std::make_shared<FSceneCache>();
		if (Study.Measure != "final" && Study.Measure != "sceneLinear")
		{
			Options.Dump.push_back(GetDumped());
		}
	}

	FMeasured RunReference(const FStudySet& Case) override { return Run(Join(Case, Study.Reference)); }

	FMeasured Run(const FStudySet& Set) override
	{
		FRunOptions RunOptions = Options;
		ApplyToRun(Set, RunOptions);
		const FRunResult Result = RunConfig(RunOptions);
		FMeasured Measured;
		Measured.Image = Pick(Result, Measured.Encoding);
		const double NumPixels = static_cast<double>(Result.ViewRect.Width()) * Result.ViewRect.Height();
		bool bFound = false;
		for (const FRunPass& Pass : Result.Passes)
		{
			if (!IsPassNamed(Study.Passes, Result.Graph.Passes[static_cast<size_t>(Pass.Index)].Name))
			{
				continue;
			}
			bFound = true;
			Measured.Milliseconds += Pass.Milliseconds;
			Measured.Taps += Pass.Taps ? static_cast<double>(*Pass.Taps) / NumPixels : std::nan("");
			Measured.Bytes += static_cast<double>(Pass.Counters.BytesRead + Pass.Counters.BytesWritten) / NumPixels;
		}
		if (!bFound)
		{
			throw MakeStudyError(ErrorUnknownValue, Result.Config, {0, 0, "/study/passes"},
				"\"" + Study.Passes + "\" fits no pass of this frame");
		}
		return Measured;
	}

	void Prepare(const FStudySet&, FStudyVariant&) override {}

	std::string DescribeReference(const FStudySet&) override
	{
		return Study.ReferenceName == "double" ? "the same shaders in double, 64-bit storage, coordinates not snapped"
											   : Study.ReferenceName;
	}

private:
	/** The blurred toon shadow is in the alpha of what its last pass writes. */
	std::string GetDumped() const { return Study.Measure == "toonShadow" ? "ToonShadowCombine" : Study.Measure; }

	/** As it would be displayed, whatever it is stored as. */
	static FImage DecodeToonShadow(const FImage& Stored, EToonShadowBlurStore Store)
	{
		FImage Shadow{Stored.Width, Stored.Height, 1, {}};
		for (size_t Pixel = 3; Pixel < Stored.Values.size(); Pixel += 4)
		{
			const float Value = static_cast<float>(Stored.Values[Pixel]);
			Shadow.Values.push_back(EncodeDisplay(static_cast<double>(DecodeToonShadowBlur(Value, Store))));
		}
		return Shadow;
	}

	FImage Pick(const FRunResult& Result, EImageEncoding& Encoding) const
	{
		if (Study.Measure == "final")
		{
			Encoding = EImageEncoding::Display;
			return Result.Final.ToImage();
		}
		if (Study.Measure == "sceneLinear")
		{
			return Result.SceneLinear.ToImage();
		}
		// The last one that fits: what a chain of passes ends with.
		for (size_t Index = Result.Dumps.size(); Index-- > 0;)
		{
			const FRunDump& Dump = Result.Dumps[Index];
			if (Dump.Mip <= 0 && IsDumped({{GetDumped(), {}}}, Dump.Pass, Dump.Resource))
			{
				if (Study.Measure == "toonShadow" && Dump.Image.NumChannels == 4)
				{
					Encoding = EImageEncoding::Display;
					return DecodeToonShadow(Dump.Image.ToImage(), Result.Settings.ToonShadowBlurStore);
				}
				return Dump.Image.ToImage();
			}
		}
		throw MakeStudyError(ErrorUnknownValue, Result.Config, {0, 0, "/study/measure"},
			"\"" + Study.Measure + "\" fits no resource that a pass of this frame wrote");
	}

	FRunOptions Options;
	const FStudy& Study;
};

} // namespace

FStudySet Join(const FStudySet& A, const FStudySet& B)
{
	FStudySet Both = A;
	Both.insert(Both.end(), B.begin(), B.end());
	return Both;
}

FImage MakeBlurInput(const std::string& Input, const FImage& Scene, double Sigma)
{
	if (Input == "scene")
	{
		return Scene;
	}
	FImage Image{Scene.Width, Scene.Height, 4, {}};
	Image.Values.reserve(Scene.Values.size());
	const int PointX = Scene.Width * 2 / 5;
	const int PointY = Scene.Height * 3 / 5;
	const double Brightness = 2.0 * std::numbers::pi * Sigma * Sigma;
	for (int Y = 0; Y < Scene.Height; ++Y)
	{
		for (int X = 0; X < Scene.Width; ++X)
		{
			const bool bLit =
				Input == "point" ? X == PointX && Y == PointY : 3 * (X - Scene.Width / 2) > Y - Scene.Height / 2;
			const double Value = !bLit ? 0.0 : Input == "point" ? Brightness : 1.0;
			Image.Values.insert(Image.Values.end(), {Value, Value, Value, 1.0});
		}
	}
	return Image;
}

FError MakeStudyError(EConfigError Code, const FConfig& Config, const FConfigPlace& Place, const std::string& Message)
{
	return FError({.Code = Code,
					  .Message = Message,
					  .File = Config.File,
					  .Line = Place.Line,
					  .Column = Place.Column,
					  .Where = Place.Pointer},
		ExitUsage);
}

std::unique_ptr<IStudySubject> MakeBlurSubject(const FConfig& Config)
{
	return std::make_unique<FBlurSubject>(Config);
}

std::unique_ptr<IStudySubject> MakeFrameSubject(const FRunOptions& Options, const FStudy& Study)
{
	return std::make_unique<FFrameSubject>(Options, Study);
}

} // namespace Drydock
