// Builds the tree from nlohmann-json's events. The grammar is that parser's; positions come from the scan before it,
// which lists keys and values in the order in which the parser reports them.
#include <nlohmann/json.hpp>

#include "Text/Json.h"

#include "DiagnosticList.h"
#include "RangeTools.h"
#include "RegularFile.h"
#include "Text/ConfigErrors.h"
#include "Text/JsonMistake.h"
#include "Text/JsonScan.h"
#include "Text/LimitErrors.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>

namespace Drydock
{

namespace
{

/** Deeper than any config, shallow enough for recursive readers. */
constexpr size_t MaxDepth = 64;

/** More than any config has. Each takes some 200 bytes, wherever it stands: half a gigabyte while they are collected.
 */
constexpr size_t MaxValues = 1'000'000;

/** Bytes of a pointer. Behind that it goes on with "...", for each value has its own, and keys may be long. */
constexpr size_t MaxPointer = 240;

std::string EscapePointer(const std::string& Key)
{
	std::string Escaped;
	for (const char Character : Key)
	{
		Escaped += Character == '~' ? "~0" : Character == '/' ? "~1" : std::string(1, Character);
	}
	return Escaped;
}

/** Builds the tree from SAX events. Callback names are nlohmann's. */
class FTreeBuilder
{
public:
	FTreeBuilder(const std::string& Text, const FJsonScan& InScan, const std::string& InFile,
		std::vector<FDiagnostic>& InDiagnostics)
		: Scan(InScan)
		, Positions(Text)
		, File(InFile)
		, Diagnostics(InDiagnostics)
	{
	}

	bool null() { return AddLeaf({}); }
	bool boolean(bool bValue)
	{
		FJsonValue Value;
		Value.Type = EJsonType::Bool;
		Value.Bool = bValue;
		return AddLeaf(std::move(Value));
	}
	bool number_integer(std::int64_t Number) { return AddNumber(static_cast<double>(Number)); }
	bool number_unsigned(std::uint64_t Number) { return AddNumber(static_cast<double>(Number)); }
	bool number_float(double Number, const std::string&) { return AddNumber(Number); }
	bool string(std::string& Text)
	{
		FJsonValue Value;
		Value.Type = EJsonType::String;
		Value.String = Text;
		return HoldsNul(Text) ? (RefuseNul(Frames.empty() ? "" : PointerOf(Frames.back()))) : AddLeaf(std::move(Value));
	}
	bool binary(std::vector<std::uint8_t>&) { return false; }
	bool start_object(size_t) { return Open(EJsonType::Object); }
	bool start_array(size_t) { return Open(EJsonType::Array); }
	bool end_object() { return Close(); }
	bool end_array() { return Close(); }

	bool key(std::string& Key)
	{
		if (HoldsNul(Key))
		{
			return RefuseNul(CurrentPointer());
		}
		const FTextPosition Position = Positions.Find(TakeToken().Offset);
		FFrame& Frame = Frames.back();
		Frame.Key = Key;
		Frame.KeyPosition = Position;
		const auto [First, bNew] = Frame.KeyLines.emplace(Key, Position.Line);
		Frame.bDuplicate = !bNew;
		if (Frame.bDuplicate)
		{
			Report(ErrorDuplicateKey, Position, PointerOf(Frame),
				"key \"" + Key + "\" appears twice in this object; first on line " + std::to_string(First->second));
		}
		return true;
	}

	bool parse_error(size_t Position, const std::string&, const nlohmann::detail::exception& Exception)
	{
		// "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error while parsing ...": the place
		// is reported separately.
		FJsonMistake Mistake = DescribeJsonMistake(Scan.Text, Position == 0 ? 0 : Position - 1);
		if (Mistake.Message.empty())
		{
			Mistake.Message = Exception.what();
			const size_t Place = Mistake.Message.find("column ");
			const size_t Colon = Place == std::string::npos ? std::string::npos : Mistake.Message.find(": ", Place);
			Mistake.Message = Colon == std::string::npos ? Mistake.Message : Mistake.Message.substr(Colon + 2);
		}
		Report(ErrorJsonSyntax, Positions.Find(Mistake.Offset), CurrentPointer(), Mistake.Message);
		return false;
	}

	FJsonValue TakeRoot()
	{
		while (Frames.size() > 1)
		{
			Close();
		}
		return Frames.empty() ? std::move(Root) : std::move(Frames.front().Value);
	}

	bool HasSyntaxError() const { return bSyntaxError; }

private:
	struct FFrame
	{
		FJsonValue Value;
		std::string Key; // of the member being read
		FTextPosition KeyPosition;
		bool bDuplicate = false; // the member's key stood there before
		std::unordered_map<std::string, int> KeyLines;
	};

	static std::string PointerOf(const FFrame& Frame)
	{
		const std::string& Parent = Frame.Value.Pointer;
		const std::string Pointer =
			Parent + "/" +
			(Frame.Value.Type == EJsonType::Array ? std::to_string(Frame.Value.Elements.size())
												  : EscapePointer(Frame.Key.substr(0, MaxPointer)));
		return Pointer.size() <= MaxPointer ? Pointer : Parent.ends_with("/...") ? Parent : Parent + "/...";
	}

	std::string CurrentPointer() const { return Frames.empty() ? "" : Frames.back().Value.Pointer; }

	void Report(int Code, FTextPosition Position, const std::string& Pointer, const std::string& Message)
	{
		bSyntaxError = bSyntaxError || Code == ErrorJsonSyntax || Code == ErrorJsonDepth;
		AddDiagnostic(Diagnostics, {.Code = Code,
									   .Message = Message,
									   .File = File,
									   .Line = Position.Line,
									   .Column = Position.Column,
									   .Where = Pointer});
	}

	/** Reports what ends the file although it is JSON. */
	bool Refuse(int Code, FTextPosition Position, const std::string& Pointer, const std::string& Message)
	{
		bSyntaxError = true;
		Report(Code, Position, Pointer, Message);
		return false;
	}

	/** A name or path with one ends there for half of all readers, and not for the other half. */
	static bool HoldsNul(const std::string& Text) { return Text.find('\0') != std::string::npos; }

	bool RefuseNul(const std::string& Pointer)
	{
		return Refuse(ErrorBadValue, Positions.Find(TakeToken().Offset), Pointer,
			"the text holds the character NUL (\\u0000), which no name, path or value can");
	}

	/** The scan's next key or value. A text that the two lexers cut differently is a syntax error sooner or later;
	 * until then its last known place will do. */
	FJsonToken TakeToken()
	{
		return NextToken < Scan.Tokens.size() ? Scan.Tokens[NextToken++]
			   : Scan.Tokens.empty()          ? FJsonToken()
											  : Scan.Tokens.back();
	}

	/** Gives a value that has just begun its place. False: there are too many. */
	bool Locate(FJsonValue& Value)
	{
		const FTextPosition Position = Positions.Find(TakeToken().Offset);
		Value.Line = Position.Line;
		Value.Column = Position.Column;
		if (!Frames.empty())
		{
			Value.Pointer = PointerOf(Frames.back());
			Value.KeyLine = Frames.back().KeyPosition.Line;
			Value.KeyColumn = Frames.back().KeyPosition.Column;
		}
		return ++NumValues <= MaxValues || Refuse(ErrorTooManyValues, Position, Value.Pointer,
											   "more than " + std::to_string(MaxValues) + " values; no more are read");
	}

	bool AddNumber(double Number)
	{
		const bool bNotFinite = NextToken < Scan.Tokens.size() && Scan.Tokens[NextToken].bNotFinite;
		const bool bNegative = NextToken < Scan.Tokens.size() && Scan.Text[Scan.Tokens[NextToken].Offset] == '-';
		FJsonValue Value;
		Value.Type = bNotFinite ? EJsonType::Invalid : EJsonType::Number;
		Value.Number = std::copysign(Number, bNegative ? -1.0 : 1.0); // the parser takes -0 for an integer, 0
		if (!Locate(Value))
		{
			return false;
		}
		if (bNotFinite)
		{
			Report(ErrorNumberNotFinite, {Value.Line, Value.Column}, Value.Pointer,
				"not a finite number; JSON has no NaN and no Infinity, and numbers must fit a double");
		}
		Attach(std::move(Value));
		return true;
	}

	bool AddLeaf(FJsonValue Value)
	{
		if (!Locate(Value))
		{
			return false;
		}
		Attach(std::move(Value));
		return true;
	}

	bool Open(EJsonType Type)
	{
		FJsonValue Value;
		Value.Type = Type;
		if (!Locate(Value))
		{
			return false;
		}
		if (Frames.size() >= MaxDepth)
		{
			Report(ErrorJsonDepth, {Value.Line, Value.Column}, Value.Pointer,
				"nested deeper than " + std::to_string(MaxDepth) + " levels");
			return false;
		}
		Frames.emplace_back().Value = std::move(Value);
		return true;
	}

	bool Close()
	{
		FJsonValue Value = std::move(Frames.back().Value);
		Frames.pop_back();
		Attach(std::move(Value));
		return true;
	}

	void Attach(FJsonValue Value)
	{
		if (Frames.empty())
		{
			Root = std::move(Value);
			return;
		}
		FFrame& Parent = Frames.back();
		if (Parent.Value.Type == EJsonType::Array)
		{
			Parent.Value.Elements.push_back(std::move(Value));
		}
		else if (!Parent.bDuplicate)
		{
			Parent.Value.Members.push_back({Parent.Key, std::move(Value)});
		}
	}

	const FJsonScan& Scan;
	FTextPositions Positions;
	const std::string& File;
	std::vector<FDiagnostic>& Diagnostics;
	std::vector<FFrame> Frames;
	FJsonValue Root;
	size_t NextToken = 0;
	size_t NumValues = 0;
	bool bSyntaxError = false;
};

} // namespace

const FJsonValue* FJsonValue::Find(const std::string& Key) const
{
	const FJsonMember* const Member = FindItem(Members, Key, &FJsonMember::Key);
	return Member != nullptr ? &Member->Value : nullptr;
}

double FJsonValue::GetNumber(const std::string& Key, double Otherwise) const
{
	const FJsonValue* Value = Find(Key);
	return Value != nullptr && Value->Type == EJsonType::Number ? Value->Number : Otherwise;
}

std::string FJsonValue::GetString(const std::string& Key) const
{
	const FJsonValue* Value = Find(Key);
	return Value != nullptr ? Value->String : "";
}

const std::vector<FJsonValue>& FJsonValue::GetElements(const std::string& Key) const
{
	static const std::vector<FJsonValue> None;
	const FJsonValue* Value = Find(Key);
	return Value != nullptr ? Value->Elements : None;
}

const char* FJsonValue::Describe() const
{
	constexpr const char* Names[] = {
		"null", "true or false", "a number", "a string", "an array", "an object", "a number that is not finite"};
	return Names[size_t(Type)];
}

FJsonValue ParseJson(
	const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics, bool& OutSyntaxError)
{
	if (Text.size() > MaxTextBytes)
	{
		OutSyntaxError = true;
		AddDiagnostic(Diagnostics, {.Code = ErrorTextTooLarge,
									   .Message = "the text has " + std::to_string(Text.size()) +
												  " bytes, and at most " + std::to_string(MaxTextBytes) + " are read",
									   .File = File});
		return {};
	}
	const FJsonScan Scan = ScanJson(Text, 2 * MaxValues + 2); // a key and a value each
	FTreeBuilder Builder(Text, Scan, File, Diagnostics);
	const bool bRead = nlohmann::json::sax_parse(Scan.Text, &Builder, nlohmann::json::input_format_t::json, true, true);
	OutSyntaxError = !bRead || Builder.HasSyntaxError();
	return Builder.TakeRoot();
}

} // namespace Drydock
