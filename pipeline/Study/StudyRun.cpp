// Runs all variants of a study in turn, measures their errors and times, and ranks them.
#include "Study/StudyRun.h"

#include "Budget/StudyRequest.h"
#include "Config/ConfigPlaces.h"
#include "Config/ReadConfig.h"
#include "HAL/IConsoleManager.h"
#include "Math/ToInteger.h"
#include "PostProcessSettingsReflection.h"
#include "Run/Run.h"
#include "Run/RunSetup.h"
#include "Study/StudyRank.h"
#include "Study/StudySubject.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "TileExecutor.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>

namespace Drydock
{

namespace
{

/** The reference takes longer than what it is compared with, and its time is but a yardstick. */
constexpr size_t MostReferenceRuns = 3;

using FSet = FStudySet;

/** Stretched over another size, as a bilinear sampler with clamped edges reads it. */
FImage Stretch(const FImage& Image, int Width, int Height)
{
	if (Image.Width == Width && Image.Height == Height)
	{
		return Image;
	}
	FImage Result{Width, Height, Image.NumChannels, {}};
	for (int Y = 0; Y < Height; ++Y)
	{
		const double V = (Y + 0.5) * Image.Height / Height - 0.5;
		const int Y0 = ToInteger<int>(std::floor(V));
		for (int X = 0; X < Width; ++X)
		{
			const double U = (X + 0.5) * Image.Width / Width - 0.5;
			const int X0 = ToInteger<int>(std::floor(U));
			for (int Channel = 0; Channel < Image.NumChannels; ++Channel)
			{
				const auto Get = [&](int DX, int DY)
				{
					return Image.Get(
						std::clamp(X0 + DX, 0, Image.Width - 1), std::clamp(Y0 + DY, 0, Image.Height - 1), Channel);
				};
				const double Upper = Get(0, 0) + (Get(1, 0) - Get(0, 0)) * (U - X0);
				const double Lower = Get(0, 1) + (Get(1, 1) - Get(0, 1)) * (U - X0);
				Result.Values.push_back(Upper + (Lower - Upper) * (V - Y0));
			}
		}
	}
	return Result;
}

/** The part that counts. */
FImage CutOutRegion(const FImage& Image, const std::optional<std::array<int, 4>>& Region)
{
	if (!Region)
	{
		return Image;
	}
	const auto& [MinX, MinY, MaxX, MaxY] = *Region;
	FImage Part{MaxX - MinX, MaxY - MinY, Image.NumChannels, {}};
	for (int Y = MinY; Y < MaxY; ++Y)
	{
		for (int X = MinX; X < MaxX; ++X)
		{
			for (int Channel = 0; Channel < Image.NumChannels; ++Channel)
			{
				Part.Values.push_back(Image.Get(X, Y, Channel));
			}
		}
	}
	return Part;
}

/** Values that the config itself gives to what the axes vary. */
std::map<std::string, std::string> GetCurrentValues(const FRunOptions& Options, const FStudy& Study)
{
	FRunOptions CheckOptions = Options;
	CheckOptions.bUseBudget = false;
	const FRunSetup Setup(CheckOptions);
	std::map<std::string, std::string> Values = {
		{"precision", Options.bDouble ? "double" : "float"}, {"storage", Options.bDouble ? "float64" : "native"}};
	const FJsonValue Root = ParseConfigDocument(GetConfigText(Options), Options.ConfigFile).Root;
	for (const FStudyAxis& Axis : Study.Axes)
	{
		for (const FStudyValue& Value : Axis.Values)
		{
			for (const FStudyAssignment& Assignment : Value.Set)
			{
				const IConsoleVariable* Variable = IConsoleManager::Get().FindConsoleVariable(Assignment.Name.c_str());
				const FSettingField* Field = FindSettingField(Assignment.Name);
				FSettingValue Wanted;
				std::string Expected;
				if (const std::optional<std::string> Text = FindPlaceText(Root, Assignment.Name))
				{
					Values[Assignment.Name] = *Text;
				}
				else if (Variable != nullptr)
				{
					// In the variable's own words: 1 and true are the same to a bool.
					Values[Assignment.Name] = *Variable->GetString();
				}
				else if (Field != nullptr && SettingFromText(*Field, Assignment.Value, Wanted, Expected) &&
						 SettingToJson(*Field, Wanted) == SettingToJson(*Field, Field->Get(Setup.Settings.Settings)))
				{
					Values[Assignment.Name] = Assignment.Value;
				}
			}
		}
	}
	return Values;
}

bool IsCurrent(const FSet& Set, const std::map<std::string, std::string>& Values)
{
	return std::all_of(Set.begin(), Set.end(),
		[&](const FStudyAssignment& Assignment)
		{
			const auto Found = Values.find(Assignment.Name);
			if (Found == Values.end())
			{
				return false;
			}
			char* End = nullptr;
			const double A = std::strtod(Found->second.c_str(), &End);
			const bool bNumber = !Found->second.empty() && *End == '\0';
			return Found->second == Assignment.Value ||
				   (bNumber && A == std::strtod(Assignment.Value.c_str(), nullptr));
		});
}

std::map<std::string, std::string> GetCurrentOf(const FRunOptions& Options, const FStudy& Study)
{
	if (!Study.bBlur)
	{
		return GetCurrentValues(Options, Study);
	}
	std::map<std::string, std::string> Values;
	for (const FStudyAssignment& Assignment : Study.Current)
	{
		Values[Assignment.Name] = Assignment.Value;
	}
	return Values;
}

// The whole ---------------------------------------------------------------------------------------------------------

class FStudyRunner
{
public:
	FStudyRunner(
		const FRunOptions& InOptions, const FCheckResult& InCheck, const FStudy& InStudy, IStudySubject& InSubject)
		: Options(InOptions)
		, Check(InCheck)
		, Study(InStudy)
		, Subject(InSubject)
	{
	}

	FStudyResult Run()
	{
		const auto Begin = std::chrono::steady_clock::now();
		const FConfig& Config = Check.Config;
		Result.Study = Study;
		Result.Name = std::filesystem::path(Config.File).stem().string();
		Result.ConfigFile = Config.File;
		Result.Fingerprint = GetStudyFingerprint(GetConfigText(Options));
		Result.Scene = Config.Scene.File.Value;
		Result.Threads = GetNumThreads();
		Result.Diagnostics = Check.Diagnostics;
		MakeVariants();
		MeasureErrors();
		MeasureTimes();
		RankStudy(Result);
		Result.Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - Begin).count();
		return std::move(Result);
	}

private:
	FSet GetSet(const FStudyVariant& Variant) const
	{
		return Join(Result.Jobs[Variant.Case].Case.Set, Choices[Variant.Choice].Set);
	}

	void Show(const std::string& What) const
	{
		if (Options.Progress)
		{
			Options.Progress(NumDone, NumToDo, What);
		}
	}

	void MakeVariants()
	{
		Choices = Study.GetChoices();
		const std::map<std::string, std::string> Current = GetCurrentOf(Options, Study);
		for (const FStudyCase& Case : Study.GetCases())
		{
			FStudyJob Job;
			Job.Case = Case;
			Job.Reference = Subject.DescribeReference(Case.Set);
			Result.Jobs.push_back(Job);
			for (size_t Choice = 0; Choice < Choices.size(); ++Choice)
			{
				FStudyVariant Variant;
				Variant.Case = Result.Jobs.size() - 1;
				Variant.Choice = Choice;
				Variant.Label = Choices[Choice].Label;
				Variant.bCurrent = !Current.empty() && IsCurrent(Choices[Choice].Set, Current);
				Result.Jobs.back().Variants.push_back(Result.Variants.size());
				Result.Variants.push_back(std::move(Variant));
			}
		}
		NumToDo = static_cast<int>(Result.Variants.size() * static_cast<size_t>(Study.Repetitions + 1));
	}

	/** Throws where the region leaves the picture. */
	void CheckRegion() const
	{
		if (Study.Region && ((*Study.Region)[2] > Result.Width || (*Study.Region)[3] > Result.Height))
		{
			throw MakeStudyError(ErrorBadValue, Check.Config, {0, 0, "/study/region"},
				fmt::format("the region leaves the picture, which is {} x {} pixels", Result.Width, Result.Height));
		}
	}

	/** This is the warm-up too: shaders are compiled and the scene is in memory afterwards. */
	void MeasureErrors()
	{
		for (FStudyJob& Job : Result.Jobs)
		{
			Show(Job.Case.Label + " reference");
			const FMeasured Reference = Subject.RunReference(Job.Case.Set);
			Job.ReferenceTaps = Reference.Taps;
			Result.Width = Reference.Image.Width;
			Result.Height = Reference.Image.Height;
			CheckRegion();
			const FImage ReferencePart = CutOutRegion(Reference.Image, Study.Region);
			for (const size_t Index : Job.Variants)
			{
				FStudyVariant& Variant = Result.Variants[Index];
				Show(Job.Case.Label + " " + Variant.Label);
				++NumDone;
				Subject.Prepare(GetSet(Variant), Variant);
				if (Variant.Exclusion == EStudyExclusion::NotRun)
				{
					continue;
				}
				const FMeasured Measured = Subject.Run(GetSet(Variant));
				const FImage Image = Stretch(Measured.Image, Result.Width, Result.Height);
				FImageErrorOptions ErrorOptions{Measured.Encoding, std::min(3, Image.NumChannels)};
				Variant.Error = CompareImages(CutOutRegion(Image, Study.Region), ReferencePart, ErrorOptions);
				ErrorOptions.bPerceived = false;
				Variant.RelativeWithBorder = Study.Region ? CompareImages(Image, Reference.Image, ErrorOptions).Relative
														  : Variant.Error.Relative;
				Variant.Taps = Measured.Taps;
				Variant.Bytes = Measured.Bytes;
				Variant.bRan = true;
			}
		}
	}

	/** Runs of what takes the same time are made once for all of it. */
	void MeasureTimes()
	{
		std::map<std::string, std::vector<double>> Runs; // by time key
		std::map<std::string, std::vector<double>> ReferenceRuns;
		const auto GetKey = [](const std::string& Key, size_t Index)
		{
			return Key.empty() ? std::to_string(Index) : Key;
		};
		std::vector<std::string> Keys;
		std::vector<std::string> ReferenceKeys;
		for (const FStudyVariant& Variant : Result.Variants)
		{
			Keys.push_back(GetKey(Subject.GetTimeKey(GetSet(Variant)), Keys.size()));
		}
		for (const FStudyJob& Job : Result.Jobs)
		{
			ReferenceKeys.push_back(GetKey(Subject.GetTimeKey(Job.Case.Set), ReferenceKeys.size()));
		}
		for (int Repetition = 0; Repetition < Study.Repetitions; ++Repetition)
		{
			const size_t Wanted = static_cast<size_t>(Repetition) + 1;
			for (size_t JobIndex = 0; JobIndex < Result.Jobs.size(); ++JobIndex)
			{
				const FStudyJob& Job = Result.Jobs[JobIndex];
				std::vector<double>& OfReference = ReferenceRuns[ReferenceKeys[JobIndex]];
				if (OfReference.size() < Wanted && Wanted <= MostReferenceRuns)
				{
					OfReference.push_back(Subject.RunReference(Job.Case.Set).Milliseconds);
				}
				for (const size_t Index : Job.Variants)
				{
					const FStudyVariant& Variant = Result.Variants[Index];
					std::vector<double>& OfVariant = Runs[Keys[Index]];
					Show(Job.Case.Label + " " + Variant.Label);
					++NumDone;
					if (Variant.bRan && OfVariant.size() < Wanted)
					{
						OfVariant.push_back(Subject.Run(GetSet(Variant)).Milliseconds);
					}
				}
			}
		}
		for (size_t Index = 0; Index < Result.Variants.size(); ++Index)
		{
			Result.Variants[Index].Time = SummarizeRuns(Runs[Keys[Index]]);
		}
		for (size_t JobIndex = 0; JobIndex < Result.Jobs.size(); ++JobIndex)
		{
			Result.Jobs[JobIndex].ReferenceTime = SummarizeRuns(ReferenceRuns[ReferenceKeys[JobIndex]]);
		}
	}

	const FRunOptions& Options;
	const FCheckResult& Check;
	const FStudy& Study;
	IStudySubject& Subject;
	std::vector<FStudyChoice> Choices;
	FStudyResult Result;
	int NumDone = 0;
	int NumToDo = 0;
};

} // namespace

struct FStudyRun::FState
{
	explicit FState(const FRunOptions& InOptions)
		: Options(InOptions)
	{
		FRunOptions CheckOptions = Options;
		CheckOptions.bUseBudget = false;
		Check = CheckConfig(CheckOptions);
		std::vector<FDiagnostic> Found;
		std::optional<FStudy> Read = ReadStudy(Check.Config, Found);
		if (HasErrors(Found))
		{
			throw FError(Found, ExitUsage);
		}
		if (!Read)
		{
			throw MakeStudyError(ErrorMissingKey, Check.Config, {}, "the config has no \"study\"");
		}
		Study = std::move(*Read);
		CheckPlaces(CheckOptions);
		Subject = Study.bBlur ? MakeBlurSubject(Check.Config) : MakeFrameSubject(Options, Study);
	}

	/** Throws the mistakes in places of the config before anything runs. */
	void CheckPlaces(const FRunOptions& CheckOptions) const
	{
		const auto CheckSet = [&](const FSet& Set)
		{
			FRunOptions Changed = CheckOptions;
			ApplyToRun(Set, Changed);
			if (!Changed.ConfigPlaces.empty())
			{
				FRunSetup{Changed};
			}
		};
		CheckSet(Study.Reference);
		for (const FStudyAxis& Axis : Study.Axes)
		{
			for (const FStudyValue& Value : Axis.Values)
			{
				CheckSet(Value.Set);
			}
		}
	}

	FRunOptions Options;
	FCheckResult Check;
	FStudy Study; // the subject refers to it
	std::unique_ptr<IStudySubject> Subject;
};

FStudyRun::FStudyRun(const FRunOptions& Options)
	: State(std::make_unique<FState>(Options))
{
}

FStudyRun::~FStudyRun() = default;

FStudyResult FStudyRun::Measure()
{
	return FStudyRunner(State->Options, State->Check, State->Study, *State->Subject).Run();
}

FStudyPicture FStudyRun::RunReference(const FStudyJob& Job)
{
	const FMeasured Measured = State->Subject->RunReference(Job.Case.Set);
	return {CutOutRegion(Measured.Image, State->Study.Region), Measured.Encoding};
}

FStudyPicture FStudyRun::RunVariant(const FStudyResult& Result, const FStudyVariant& Variant)
{
	const FSet& Case = Result.Jobs[Variant.Case].Case.Set;
	const FMeasured Measured = State->Subject->Run(Join(Case, State->Study.GetChoices()[Variant.Choice].Set));
	return {CutOutRegion(Stretch(Measured.Image, Result.Width, Result.Height), State->Study.Region), Measured.Encoding};
}

FStudyResult RunStudy(const FRunOptions& Options)
{
	return FStudyRun(Options).Measure();
}

} // namespace Drydock
