// Writes JSON text: keys in the order given, numbers in the shortest form that reads back to the same bits, so that
// equal data gives equal bytes.
#pragma once

#include "DrydockAPI.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

class DRYDOCK_API FJsonWriter
{
public:
	/** bInline: the whole object or array on one line. */
	void BeginObject(bool bInline = false) { Begin('{', bInline); }
	void EndObject() { End('}'); }
	void BeginArray(bool bInline = false) { Begin('[', bInline); }
	void EndArray() { End(']'); }

	FJsonWriter& Key(const std::string& Name);

	void Value(const std::string& Text);
	void Value(const char* Text) { Value(std::string(Text)); }
	void Value(bool bValue);
	/** Writes null for a number that is not finite, because JSON has no such numbers. */
	void Value(double Number);
	void Value(float Number);
	void Value(int32_t Number) { Raw(std::to_string(Number)); }
	void Value(uint32_t Number) { Raw(std::to_string(Number)); }
	void Value(int64_t Number) { Raw(std::to_string(Number)); }
	void Value(uint64_t Number) { Raw(std::to_string(Number)); }
	void Null() { Raw("null"); }
	/** Text that is JSON already. */
	void Raw(const std::string& Json);

	template<typename T>
	void Member(const std::string& Name, const T& InValue)
	{
		Key(Name).Value(InValue);
	}

	/** Nothing is null. */
	template<typename T>
	void Member(const std::string& Name, const std::optional<T>& InValue)
	{
		Key(Name);
		InValue ? Value(*InValue) : Null();
	}

	/** The text so far, with a final line break. */
	std::string GetText() const { return Text + "\n"; }

	static std::string Quote(const std::string& Text);

private:
	struct FLevel
	{
		bool bInline = false;
		bool bEmpty = true;
	};

	void Begin(char Bracket, bool bInline);
	void End(char Bracket);
	void Separate();
	void BreakLine();

	std::string Text;
	std::vector<FLevel> Levels;
	bool bAfterKey = false;
};

} // namespace Drydock
