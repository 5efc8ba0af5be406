// Writes JSON text: keys in the order given, numbers in the shortest form that reads back to the same bits, so that
// equal data gives equal bytes.
#pragma once

#include "DrydockAPI.h"

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

namespace Drydock
{

class DRYDOCK_API FJsonWriter
{
public:
	FJsonWriter() = default;
	/** Begins with a bracket, { or [, that GetText closes. */
	explicit FJsonWriter(char Bracket) { Begin(Bracket, false); }

	/** bInline: the whole object or array on one line. */
	void BeginObject(bool bInline = false) { Begin('{', bInline); }
	void EndObject() { End(); }
	void BeginArray(bool bInline = false) { Begin('[', bInline); }
	void EndArray() { End(); }

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

	/** Nothing is null. */
	template<typename T>
	void Value(const std::optional<T>& InValue)
	{
		InValue ? Value(*InValue) : Null();
	}

	/** A list of values: an array on one line. */
	template<std::ranges::range T>
	requires(!std::same_as<std::ranges::range_value_t<T>, char>) void Value(const T& Values)
	{
		BeginArray(true);
		for (const auto& Each : Values)
		{
			Value(Each);
		}
		EndArray();
	}

	template<typename T>
	void Member(const std::string& Name, const T& InValue)
	{
		Key(Name).Value(InValue);
	}

	template<typename T>
	void Member(const std::string& Name, std::initializer_list<T> Values)
	{
		Key(Name).Value(Values);
	}

	/** A member that is left out where its value is nothing or empty. */
	template<typename T>
	void MemberIfAny(const std::string& Name, const T& InValue)
	{
		if (InValue != T())
		{
			Member(Name, InValue);
		}
	}

	/** A member whose text is JSON already; it is left out where there is none. */
	void RawMember(const std::string& Name, const std::string& Json);

	/** A member before it is written. */
	struct FMember
	{
		template<typename T>
		FMember(std::string InName, const T& Value)
			: Name(std::move(InName))
		{
			FJsonWriter Writer;
			Writer.Value(Value);
			Json = Writer.Text;
		}

		std::string Name;
		std::string Json;
	};

	void Members(std::initializer_list<FMember> Each);

	/** An object on one line. */
	void Object(std::initializer_list<FMember> Each);

	/** An array; Write writes an item. */
	template<typename TItems, typename TWrite>
	void Array(const std::string& Name, const TItems& Items, TWrite&& Write)
	{
		Key(Name).BeginArray();
		for (const auto& Item : Items)
		{
			Write(Item);
		}
		EndArray();
	}

	/** An array of objects, each on one line; Write writes the members of an item. */
	template<typename TItems, typename TWrite>
	void Objects(const std::string& Name, const TItems& Items, TWrite&& Write)
	{
		Array(Name, Items,
			[&](const auto& Item)
			{
				BeginObject(true);
				Write(Item);
				EndObject();
			});
	}

	/** An object on one line; Write writes the member of an item. */
	template<typename TItems, typename TWrite>
	void Object(const std::string& Name, const TItems& Items, TWrite&& Write)
	{
		Key(Name).BeginObject(true);
		for (const auto& Item : Items)
		{
			Write(Item);
		}
		EndObject();
	}

	/** Closes what is open. The text, with a final line break. */
	std::string GetText();

	static std::string Quote(const std::string& Text);

private:
	struct FLevel
	{
		char Closing = '}';
		bool bInline = false;
		bool bEmpty = true;
	};

	void Begin(char Bracket, bool bInline);
	void End();
	void Separate();
	void BreakLine();

	std::string Text;
	std::vector<FLevel> Levels;
	bool bAfterKey = false;
};

} // namespace Drydock
