// Reads two records side by side.
#include "Run/RunDifference.h"

#include "Run/RunDump.h"
#include "Text/Fmt.inl"
#include "Text/Json.h"
#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"
#include "Text/TextTable.h"
#include "TextTools.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

namespace Drydock
{

namespace
{

std::string DescribeValue(const FJsonValue& Value)
{
	switch (Value.Type)
	{
	case EJsonType::Bool:
		return Value.Bool ? "true" : "false";
	case EJsonType::Number:
		return NumberText(static_cast<float>(Value.Number));
	case EJsonType::String:
		return Value.String;
	case EJsonType::Array:
		return JoinText(Value.Elements, ", ", DescribeValue);
	case EJsonType::Object:
		return JoinText(Value.Members, ", ",
			[](const FJsonMember& Member) { return Member.Key + " " + DescribeValue(Member.Value); });
	default:
		return "none";
	}
}

/** The parts of a record by kind and name, in its order. */
class FRecord
{
public:
	explicit FRecord(const FJsonValue& Root)
	{
		for (const char* const Name :
			{"version", "commit", "engine", "precision", "storage", "device", "config", "budget"})
		{
			AddMember("other", Name, Root.Find(Name));
		}
		if (const FJsonValue* const Scene = Root.Find("scene"))
		{
			AddMember("other", "scene", Scene->Find("file"));
			AddMember("other", "view rect", Scene->Find("viewRect"));
		}
		if (const FJsonValue* const Exposure = Root.Find("exposure"))
		{
			AddMember("other", "exposure", Exposure->Find("scale"));
		}
		AddMembers("input", Root.Find("inputs"));
		AddMembers("setting", Root.Find("settings"));
		for (const FJsonValue& Variable : Root.GetElements("variables"))
		{
			Add("variable", Variable.GetString("name"),
				Variable.GetString("value") + " (" + Variable.GetString("setBy") + ")");
		}
		for (const FJsonValue& Effect : Root.GetElements("effects"))
		{
			const FJsonValue* const bActive = Effect.Find("active");
			Add("effect", Effect.GetString("name"),
				(bActive != nullptr && bActive->Bool ? "runs: " : "off: ") + Effect.GetString("reason"));
		}
		std::map<std::string, int> Turns;
		for (const FJsonValue& Pass : Root.GetElements("passes"))
		{
			const std::string Name = GetShortPassName(Pass.GetString("name"));
			const int Turn = ++Turns[Name];
			Add("pass", Turn > 1 ? Name + " #" + std::to_string(Turn) : Name, DescribePass(Pass));
		}
		std::string Codes;
		for (const FJsonValue& Warning : Root.GetElements("warnings"))
		{
			Codes += (Codes.empty() ? "" : ", ") + Warning.GetString("code");
		}
		Add("other", "messages", Codes.empty() ? "none" : Codes);
	}

	const std::vector<std::pair<std::string, std::string>>& GetKeys() const { return Keys; }

	std::string Find(const std::pair<std::string, std::string>& Key) const
	{
		const auto Found = Texts.find(Key);
		return Found == Texts.end() ? "" : Found->second;
	}

private:
	static std::string DescribePass(const FJsonValue& Pass)
	{
		const FJsonValue* const bExecuted = Pass.Find("executed");
		if (bExecuted == nullptr || !bExecuted->Bool)
		{
			return "left out: " + Pass.GetString("reason");
		}
		const std::string Shader = Pass.GetString("shader");
		return fmt::format("{}, {:.0f} pixels", Shader.empty() ? "no shader" : Shader, Pass.GetNumber("pixels", 0.0));
	}

	void AddMember(const char* Kind, const char* Name, const FJsonValue* Value)
	{
		if (Value != nullptr)
		{
			Add(Kind, Name, DescribeValue(*Value));
		}
	}

	void AddMembers(const char* Kind, const FJsonValue* Object)
	{
		for (size_t Index = 0; Object != nullptr && Index < Object->Members.size(); ++Index)
		{
			Add(Kind, Object->Members[Index].Key, DescribeValue(Object->Members[Index].Value));
		}
	}

	void Add(const std::string& Kind, const std::string& Name, const std::string& Text)
	{
		Keys.emplace_back(Kind, Name);
		Texts[Keys.back()] = Text;
	}

	std::vector<std::pair<std::string, std::string>> Keys;
	std::map<std::pair<std::string, std::string>, std::string> Texts;
};

std::optional<FRecord> ReadRecord(const std::string& Text)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(Text, "run.json", Ignored, bSyntaxError);
	return Root.Type != EJsonType::Object || bSyntaxError ? std::nullopt : std::optional<FRecord>(Root);
}

} // namespace

std::vector<FRunDifference> CompareRuns(const std::string& RunJsonA, const std::string& RunJsonB)
{
	const std::optional<FRecord> A = ReadRecord(RunJsonA);
	const std::optional<FRecord> B = ReadRecord(RunJsonB);
	std::vector<FRunDifference> Differences;
	if (!A || !B)
	{
		return Differences;
	}
	std::vector<std::pair<std::string, std::string>> Keys = A->GetKeys();
	std::ranges::copy_if(B->GetKeys(), std::back_inserter(Keys),
		[&](const std::pair<std::string, std::string>& Key) { return A->Find(Key).empty(); });
	for (const std::pair<std::string, std::string>& Key : Keys)
	{
		if (A->Find(Key) != B->Find(Key))
		{
			Differences.push_back({Key.first, Key.second, A->Find(Key), B->Find(Key)});
		}
	}
	// A person's own changes stand before their consequences.
	static constexpr std::array Order = {"setting", "variable", "input", "other", "effect", "pass"};
	std::ranges::stable_sort(Differences, {},
		[](const FRunDifference& Difference) { return std::ranges::find(Order, Difference.Kind) - Order.begin(); });
	return Differences;
}

void WriteRunDifferences(FJsonWriter& Writer, const char* Key, const std::vector<FRunDifference>& Differences)
{
	Writer.Array(Key, Differences,
		[&](const FRunDifference& Difference) {
			Writer.Object(
				{{"kind", Difference.Kind}, {"name", Difference.Name}, {"a", Difference.A}, {"b", Difference.B}});
		});
}

std::string FormatRunDifferences(const std::vector<FRunDifference>& Differences, size_t MaxRows, int Width)
{
	FTextTable Table{{{ETextColumn::Text}, {ETextColumn::Name}, {ETextColumn::Text}, {ETextColumn::Text}},
		{{"differs", "name", "A", "B"}}};
	const auto Shorten = [](const FRunDifference& Difference, const std::string& Text)
	{
		constexpr size_t Digits = 8; // of a fingerprint
		return Text.empty() ? "none" : Difference.Kind == "input" ? Text.substr(0, Digits) : Text;
	};
	for (size_t Index = 0; Index < std::min(MaxRows, Differences.size()); ++Index)
	{
		const FRunDifference& Difference = Differences[Index];
		Table.Rows.push_back(
			{Difference.Kind, Difference.Name, Shorten(Difference, Difference.A), Shorten(Difference, Difference.B)});
	}
	const std::string More = Differences.size() > MaxRows
								 ? fmt::format("and {} more (--json lists all)\n", Differences.size() - MaxRows)
								 : std::string();
	return Differences.empty() ? "both runs were made alike\n" : Table.Format(Width) + More;
}

FTimeSpread MakeTimeSpread(std::vector<double> Samples)
{
	std::ranges::sort(Samples);
	const auto At = [&](double Share)
	{
		const double Place = Share * static_cast<double>(Samples.size() - 1);
		const size_t Below = static_cast<size_t>(Place);
		const size_t Above = std::min(Below + 1, Samples.size() - 1);
		return Samples[Below] + (Place - static_cast<double>(Below)) * (Samples[Above] - Samples[Below]);
	};
	return {At(0.25), At(0.5), At(0.75)};
}

std::string DescribeTimes(const FTimeSpread& A, const FTimeSpread& B, int NumRepeats)
{
	constexpr int Fewest = 3; // of which quartiles say something
	if (NumRepeats < Fewest)
	{
		return "not measured: diff --repeat 7 runs both in turn";
	}
	const std::string Measured = fmt::format("A {:.1f} ms ({:.1f} to {:.1f}), B {:.1f} ms ({:.1f} to {:.1f}), medians "
											 "and quartiles of {} runs in turn",
		A.Median, A.Low, A.High, B.Median, B.Low, B.High, NumRepeats);
	const bool bFaster = B.High < A.Low;
	if (!bFaster && A.High >= B.Low)
	{
		return "no measurable difference: " + Measured;
	}
	return fmt::format("B is {:.0f} % {}: {}",
		100.0 * (bFaster ? 1.0 - B.Median / A.Median : B.Median / A.Median - 1.0), bFaster ? "faster" : "slower",
		Measured);
}

} // namespace Drydock
