// Finds the instructions of a line that make its value, and writes down what they give.
#include "LineValues.h"

#include "AuthorsNames.h"
#include "Diagnostics.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace Drydock
{

using namespace Spirv;

namespace
{

/** A step that gives a line a value. */
struct FLineStep
{
	uint32_t Step = 0;
	int Line = 0;
	std::string Name;
	uint32_t Type = 0;
	size_t Operand = 0;     // that is the value
	bool bVariable = false; // the value is the variable that operand 0 points into
};

/** The steps of each line of a file. */
class FLineSteps
{
public:
	FLineSteps(const FInspectedShader& Shader, const std::string& File)
		: Module(Shader.GetModule())
		, Names(Shader.GetProgram())
	{
		const FSpirvProgram& Program = Shader.GetProgram();
		const std::vector<bool> bAuthors = FindAuthorsBlocks(Module);
		for (size_t Block = 0; Block < Program.Blocks.size(); ++Block)
		{
			const uint32_t First = Program.Blocks[Block].FirstStep;
			const uint32_t End = bAuthors[Block] ? First + Program.Blocks[Block].NumSteps : First;
			for (uint32_t Index = First; Index < End; ++Index)
			{
				const FSpirvInstruction& I = *Program.Steps[Index].I;
				if (I.Line && IsFileNamed(Module.Files.at(I.File), File))
				{
					Lines[I.Line].push_back(Index);
					AddValue(Index, Program.Steps[Index]);
				}
			}
		}
	}

	std::vector<FLineStep> Steps;
	std::map<int, std::vector<uint32_t>> Lines; // all steps of the file

private:
	void AddValue(uint32_t Index, const FSpirvStep& Step)
	{
		const FSpirvInstruction& I = *Step.I;
		const bool bBuffer = I.Op == OpStore && Step.Place != ~0u;
		if (bBuffer || I.Op == OpImageWrite || I.Op == OpReturnValue)
		{
			const size_t Operand = bBuffer ? 1 : I.Op == OpImageWrite ? 2 : 0;
			const std::string Name = bBuffer ? "the buffer" : I.Op == OpImageWrite ? "the texture" : "return";
			Add({Index, I.Line, Name, Module.GetValueTypeId(I.Operands[Operand]), Operand, false});
		}
		else if (I.Op == OpStore)
		{
			if (const std::optional<FNamedVariable> Stored = Names.Find(I.Operands[0]))
			{
				Add({Index, I.Line, Stored->Name, Stored->Type, 0, true});
			}
		}
	}

	void Add(FLineStep Step)
	{
		if (Module.GetType(Step.Type).NumScalars)
		{
			Steps.push_back(std::move(Step));
		}
	}

	const FSpirvModule& Module;
	const FAuthorsNames Names;
};

/** Lines around this one that store something: "40 (Color), 43 (Sum)". */
std::string ListNear(const FLineSteps& Found, int Line)
{
	std::map<int, std::set<std::string>> ByLine;
	for (const FLineStep& Step : Found.Steps)
	{
		ByLine[Step.Line].insert(Step.Name);
	}
	std::vector<int> Lines = ToVector<int>(ByLine, [](const auto& Each) { return Each.first; });
	std::ranges::stable_sort(Lines, [Line](int A, int B) { return std::abs(A - Line) < std::abs(B - Line); });
	Lines.resize(std::min<size_t>(Lines.size(), 4));
	std::ranges::sort(Lines);
	return JoinText(
		Lines, ", ", [&](const int Known) { return std::to_string(Known) + " (" + *ByLine[Known].begin() + ")"; });
}

class FLineWatcher final : public IThreadWatcher
{
public:
	FLineWatcher(const FInspectedShader& InShader, const FAuthorsNames& InNames,
		const std::map<const FSpirvStep*, FLineStep>& InSteps, uint32_t InMemory, FLineValues& InValues)
		: Program(InShader.GetProgram())
		, Names(InNames)
		, Steps(InSteps)
		, Memory(InMemory)
		, Values(InValues)
	{
	}

	void BeginThread(size_t InIndex, TSpirvThread<float>&) override { Index = InIndex; }

	void OnStep(const FSpirvThreadView& Thread, const FSpirvStep& Step) override
	{
		const auto Found = Steps.find(&Step);
		if (Found == Steps.end())
		{
			return;
		}
		const FLineStep& Line = Found->second;
		uint32_t First = Memory;
		if (Memory == GNoSpirvWord)
		{
			const uint32_t Word = Program.Args[Step.FirstArg + Line.Operand];
			First = Line.bVariable ? Names.FindWords(Thread, Word) : Word;
		}
		if (First == GNoSpirvWord)
		{
			return;
		}
		Values.bReached[Index] = 1;
		for (int c = 0; c < Values.NumChannels; ++c)
		{
			const ESpirvType Kind = Program.Module.GetScalarKind(Line.Type, uint32_t(c));
			const uint32_t Word = First + uint32_t(c);
			Values.Values[Index * size_t(Values.NumChannels) + size_t(c)] = float(Thread.GetNumber(Word, Kind));
		}
	}

private:
	const FSpirvProgram& Program;
	const FAuthorsNames& Names;
	const std::map<const FSpirvStep*, FLineStep>& Steps;
	const uint32_t Memory; // of a variable that the line only reads
	FLineValues& Values;   // a row of pieces: each watcher writes its own threads
	size_t Index = 0;
};

/** A variable that the line does not store: of several with this name that which is used nearest before it. */
std::optional<uint32_t> FindVariable(const FInspectedShader& Shader, const FLineSteps& Found, const FLinePlace& Place)
{
	const FSpirvModule& Module = Shader.GetModule();
	const FSpirvProgram& Program = Shader.GetProgram();
	std::optional<uint32_t> Best;
	for (const auto& [Line, Steps] : Found.Lines)
	{
		for (const uint32_t Index : Steps)
		{
			for (const uint32_t Operand : Program.Steps[Index].I->Operands)
			{
				const auto Variable = Module.VariableIndex.find(Operand);
				const bool bNamed = Variable != Module.VariableIndex.end() &&
									Program.VariableNames[Variable->second] == Place.Variable &&
									Program.Memory[Variable->second].Size;
				if (bNamed && (Line <= Place.Line || !Best))
				{
					Best = Variable->second;
				}
			}
		}
	}
	return Best;
}

std::string ListNames(const FInspectedShader& Shader)
{
	std::set<std::string> Names(Shader.GetProgram().VariableNames.begin(), Shader.GetProgram().VariableNames.end());
	Names.erase(std::string());
	return JoinText(Names);
}

} // namespace

FLinePlace ParseLinePlace(const std::string& Text)
{
	const size_t Colon = Text.find(':');
	const size_t Second = Colon == std::string::npos ? Colon : Text.find(':', Colon + 1);
	FLinePlace Place;
	Place.File = Text.substr(0, Colon);
	const std::string Number = Colon == std::string::npos ? std::string() : Text.substr(Colon + 1, Second - Colon - 1);
	Place.Line = ParseAll<int>(Number).value_or(0);
	if (Place.File.empty() || Place.Line < 1)
	{
		throw FError({.Code = 1020,
						 .Message = "'" + Text + "' is not a line; expected FILE.usf:LINE or FILE.usf:LINE:VARIABLE",
						 .Where = "--show"},
			ExitUsage);
	}
	Place.Variable = Second == std::string::npos ? std::string() : Text.substr(Second + 1);
	return Place;
}

bool IsFileNamed(const std::string& Path, const std::string& Name)
{
	return Path == Name ||
		   (Path.size() > Name.size() && Path.ends_with(Name) && Path[Path.size() - Name.size() - 1] == '/');
}

std::optional<FLineValues> CollectLineValues(FInspectedShader& Shader, const FBoundShader& Bound,
	const FKernelArgs& Args, const FKernelTile& Whole, const FLinePlace& Place, std::string& Problem)
{
	const FLineSteps Found(Shader, Place.File);
	if (Found.Lines.empty())
	{
		return std::nullopt;
	}
	const std::string At = Place.File + ":" + std::to_string(Place.Line);
	const FSpirvProgram& Program = Shader.GetProgram();
	std::vector<FLineStep> Chosen;
	for (const FLineStep& Step : Found.Steps)
	{
		if (Step.Line == Place.Line && (Place.Variable.empty() || Place.Variable == Step.Name))
		{
			Chosen.push_back(Step);
		}
	}
	uint32_t Memory = GNoSpirvWord;
	const auto OnLine = Found.Lines.find(Place.Line);
	if (Chosen.empty() && !Place.Variable.empty() && OnLine != Found.Lines.end())
	{
		const std::optional<uint32_t> Variable = FindVariable(Shader, Found, Place);
		if (!Variable)
		{
			Problem = At + " has no variable '" + Place.Variable + "'; there are " + ListNames(Shader);
			return std::nullopt;
		}
		Memory = Program.Memory[*Variable].First;
		for (const uint32_t Index : OnLine->second)
		{
			Chosen.push_back(
				{Index, Place.Line, Place.Variable, Shader.GetModule().Variables[*Variable].Type, 0, true});
		}
	}
	if (Chosen.empty())
	{
		Problem = At + " computes no value" +
				  (Found.Steps.empty() ? std::string() : "; lines near it that do: " + ListNear(Found, Place.Line));
		return std::nullopt;
	}
	FLineValues Values;
	const FLineStep& Last = Chosen.back();
	std::map<const FSpirvStep*, FLineStep> Steps;
	for (const FLineStep& Step : Chosen)
	{
		if (Step.Name == Last.Name && Step.Type == Last.Type)
		{
			Steps.emplace(&Program.Steps[Step.Step], Step);
		}
	}
	const FSpirvInstruction& I = *Program.Steps[Last.Step].I;
	Values.File = Shader.GetModule().Files.at(I.File);
	Values.Variable = Last.Name;
	Values.Source = Shader.GetTrimmedLine(Values.File, Place.Line);
	Values.NumNumbers = Shader.GetModule().GetType(Last.Type).NumScalars;
	Values.NumChannels = int(std::min<uint32_t>(4, Values.NumNumbers));
	Values.Width = Whole.MaxX - Whole.MinX;
	Values.Height = (Whole.MaxY - Whole.MinY) * (Whole.MaxZ - Whole.MinZ);
	const FThreadRuns Runs(Shader, Bound, Args, ListThreads(Whole));
	Values.bReached.resize(Runs.GetThreads().size());
	Values.Values.resize(Values.bReached.size() * size_t(Values.NumChannels));
	for (FSpirvStep& Step : Shader.GetProgram().Steps)
	{
		Step.bHook = Steps.count(&Step) != 0;
	}
	const FAuthorsNames Names(Program);
	std::deque<FLineWatcher> Watchers;
	for (size_t Piece = 0; Piece < Runs.GetNumPieces(); ++Piece)
	{
		Watchers.emplace_back(Shader, Names, Steps, Memory, Values);
	}
	Runs.Run([&](size_t Piece) -> IThreadWatcher& { return Watchers[Piece]; });
	return Values;
}

namespace
{

class FRangeWatcher final : public IThreadWatcher
{
public:
	FRangeWatcher(const FSpirvProgram& InProgram, const FAuthorsNames& InNames,
		const std::map<const FSpirvStep*, std::vector<FLineStep>>& InSteps)
		: Program(InProgram)
		, Names(InNames)
		, Steps(InSteps)
	{
	}

	void OnStep(const FSpirvThreadView& Thread, const FSpirvStep& Step) override
	{
		const auto Found = Steps.find(&Step);
		for (const FLineStep& Line : Found == Steps.end() ? std::vector<FLineStep>() : Found->second)
		{
			const uint32_t Word = Program.Args[Step.FirstArg + Line.Operand];
			const uint32_t First = Line.bVariable ? Names.FindWords(Thread, Word) : Word;
			const uint32_t Size = First == GNoSpirvWord ? 0 : Program.Module.GetType(Line.Type).NumScalars;
			FLineRange& Range = Ranges[{Step.I->File, Line.Line, Line.Name}];
			Range.Times += Size > 0;
			for (uint32_t i = 0; i < Size; ++i)
			{
				const double Value = Thread.GetNumber(First + i, Program.Module.GetScalarKind(Line.Type, i));
				const bool bFinite = std::isfinite(Value);
				Range.NotFinite += !bFinite;
				Range.Least = bFinite ? std::min(Range.Least, Value) : Range.Least;
				Range.Most = bFinite ? std::max(Range.Most, Value) : Range.Most;
			}
		}
	}

	struct FNoRange : FLineRange
	{
		FNoRange()
		{
			Least = std::numeric_limits<double>::infinity();
			Most = -Least;
		}
	};
	std::map<std::tuple<uint32_t, int, std::string>, FNoRange> Ranges;

private:
	const FSpirvProgram& Program;
	const FAuthorsNames& Names;
	const std::map<const FSpirvStep*, std::vector<FLineStep>>& Steps;
};

} // namespace

std::vector<FLineRange> CollectLineRanges(FInspectedShader& Shader, const FBoundShader& Bound, const FKernelArgs& Args,
	const FKernelTile& Whole, const std::vector<std::array<int32_t, 3>>& Threads)
{
	const FSpirvProgram& Program = Shader.GetProgram();
	std::map<const FSpirvStep*, std::vector<FLineStep>> Steps;
	for (const std::string& File : Shader.GetModule().Files)
	{
		const bool bAuthors = File.ends_with(".usf") || !File.starts_with("/Engine/");
		for (const FLineStep& Step : bAuthors ? FLineSteps(Shader, File).Steps : std::vector<FLineStep>())
		{
			Steps[&Program.Steps[Step.Step]].push_back(Step);
		}
	}
	for (FSpirvStep& Step : Shader.GetProgram().Steps)
	{
		Step.bHook = Steps.contains(&Step);
	}
	const FThreadRuns Runs(Shader, Bound, Args, Threads.empty() ? ListThreads(Whole) : Threads);
	const FAuthorsNames Names(Program);
	std::deque<FRangeWatcher> Watchers;
	for (size_t Piece = 0; Piece < Runs.GetNumPieces(); ++Piece)
	{
		Watchers.emplace_back(Program, Names, Steps);
	}
	Runs.Run([&](size_t Piece) -> IThreadWatcher& { return Watchers[Piece]; });
	std::map<std::tuple<uint32_t, int, std::string>, FRangeWatcher::FNoRange> All;
	for (const FRangeWatcher& Watcher : Watchers)
	{
		for (const auto& [Key, Range] : Watcher.Ranges)
		{
			FLineRange& Sum = All[Key];
			Sum.Least = std::min(Sum.Least, Range.Least);
			Sum.Most = std::max(Sum.Most, Range.Most);
			Sum.NotFinite += Range.NotFinite;
			Sum.Times += Range.Times;
		}
	}
	std::vector<FLineRange> Ranges;
	for (auto& [Key, Range] : All)
	{
		Range.File = Shader.GetModule().Files.at(std::get<0>(Key));
		Range.Line = std::get<1>(Key);
		Range.Variable = std::get<2>(Key);
		Range.Source = Shader.GetTrimmedLine(Range.File, Range.Line);
		Ranges.push_back(Range);
	}
	return Ranges;
}

} // namespace Drydock
