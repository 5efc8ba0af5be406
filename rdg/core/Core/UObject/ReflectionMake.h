// Makes the entries of a plugin's classes, structs and enums from their C++ types, for the code that drydock_add_plugin
// generates (NAME.gen.cpp). Source of the idea: engine UObject/UnrealType.h. A little past 500 lines: generated code
// includes it alone.
#pragma once

#include "UObject/Reflection.h"

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

class UBlueprintAsyncActionBase;
class UTexture;

namespace Drydock
{

template<typename T>
const FPropertyType& GetPropertyType();

inline std::array<float*, 4> GetComponents(FLinearColor& Value)
{
	return {&Value.R, &Value.G, &Value.B, &Value.A};
}
inline std::array<uint8*, 4> GetComponents(FColor& Value)
{
	return {&Value.R, &Value.G, &Value.B, &Value.A};
}
template<typename T>
std::array<T*, 2> GetComponents(UE::Math::TVector2<T>& Value)
{
	return {&Value.X, &Value.Y};
}
template<typename T>
std::array<T*, 3> GetComponents(UE::Math::TVector<T>& Value)
{
	return {&Value.X, &Value.Y, &Value.Z};
}
template<typename T>
std::array<T*, 4> GetComponents(UE::Math::TVector4<T>& Value)
{
	return {&Value.X, &Value.Y, &Value.Z, &Value.W};
}
template<typename T>
std::array<T*, 2> GetComponents(UE::Math::TIntPoint<T>& Value)
{
	return {&Value.X, &Value.Y};
}
template<typename T>
std::array<T*, 2> GetComponents(UE::Math::TIntVector2<T>& Value)
{
	return {&Value.X, &Value.Y};
}
template<typename T>
std::array<T*, 3> GetComponents(UE::Math::TIntVector3<T>& Value)
{
	return {&Value.X, &Value.Y, &Value.Z};
}
template<typename T>
std::array<T*, 4> GetComponents(UE::Math::TIntVector4<T>& Value)
{
	return {&Value.X, &Value.Y, &Value.Z, &Value.W};
}
template<typename T>
std::array<T*, 3> GetComponents(UE::Math::TRotator<T>& Value)
{
	return {&Value.Pitch, &Value.Yaw, &Value.Roll};
}

template<typename T>
concept CHasComponents = requires(T& Value)
{
	GetComponents(Value);
};

template<typename T>
constexpr bool bIsColor = std::is_same_v<T, FLinearColor> || std::is_same_v<T, FColor>;

template<typename T>
struct TIsRotator : std::false_type
{
};
template<typename T>
struct TIsRotator<UE::Math::TRotator<T>> : std::true_type
{
};

template<typename T>
struct TArrayElementOf
{
	using Type = void;
};
template<typename T, typename Allocator>
struct TArrayElementOf<TArray<T, Allocator>>
{
	using Type = T;
};

/** The class that a pointer points to; void for all other types. */
template<typename T>
struct TPointee
{
	using Type = void;
};
template<typename T>
struct TPointee<T*>
{
	using Type = T;
};
template<typename T>
struct TPointee<TObjectPtr<T>>
{
	using Type = T;
};
template<typename T>
struct TPointee<TSoftObjectPtr<T>>
{
	using Type = T;
};
template<typename T>
struct TPointee<TWeakObjectPtr<T>>
{
	using Type = UObject;
};
template<>
struct TPointee<FSoftObjectPath>
{
	using Type = UObject;
};

template<typename T>
FPropertyType MakeObjectType()
{
	using FPointee = typename TPointee<T>::Type;
	FPropertyType Type;
	Type.Kind = EPropertyKind::Object;
	if constexpr (std::is_convertible_v<FPointee*, const UTexture*>)
	{
		Type.GetObject = [](const void* Address) -> UObject*
		{
			FPointee* const Object = *static_cast<const T*>(Address);
			return const_cast<std::remove_const_t<FPointee>*>(Object);
		};
		Type.SetObject = [](void* Address, UObject* Object)
		{
			FPointee* const Texture = dynamic_cast<FPointee*>(Object);
			if (Address != nullptr)
			{
				*static_cast<T*>(Address) = T(Texture);
			}
			return Texture != nullptr || Object == nullptr;
		};
	}
	return Type;
}

template<typename T>
void SetWholeRange(FPropertyType& Type)
{
	using FLimits = std::numeric_limits<T>;
	Type.Least = static_cast<int64>(FLimits::min());
	constexpr bool bBeyond = std::is_unsigned_v<T> && sizeof(T) == sizeof(int64);
	Type.Most = bBeyond ? std::numeric_limits<int64>::max() : static_cast<int64>(FLimits::max());
}

template<typename T>
FPropertyType MakeComponentsType()
{
	using FComponents = decltype(GetComponents(std::declval<T&>()));
	using FNumber = std::remove_pointer_t<typename FComponents::value_type>;
	FPropertyType Type;
	Type.Kind = EPropertyKind::Vector;
	Type.bWholeComponents = std::is_integral_v<FNumber>;
	Type.bFloat = std::is_same_v<FNumber, float>;
	Type.bLastMayBeMissing = bIsColor<T>;
	if constexpr (std::is_integral_v<FNumber>)
	{
		SetWholeRange<FNumber>(Type);
	}
	const char* const Names[] = {"X", "Y", "Z", "W"};
	const char* const ColorNames[] = {"R", "G", "B", "A"};
	const char* const RotatorNames[] = {"Pitch", "Yaw", "Roll", ""};
	const char* const* const Chosen = bIsColor<T> ? ColorNames : TIsRotator<T>::value ? RotatorNames : Names;
	Type.Names.assign(Chosen, Chosen + std::tuple_size_v<FComponents>);
	Type.GetReal = [](const void* Address, int32 Component)
	{
		T Copy = *static_cast<const T*>(Address);
		return static_cast<double>(*GetComponents(Copy)[static_cast<size_t>(Component)]);
	};
	Type.SetReal = [](void* Address, int32 Component, double Value)
	{
		*GetComponents(*static_cast<T*>(Address))[static_cast<size_t>(Component)] = static_cast<FNumber>(Value);
	};
	return Type;
}

template<typename T>
FPropertyType MakeArrayType()
{
	using FElement = typename TArrayElementOf<T>::Type;
	FPropertyType Type;
	Type.Kind = EPropertyKind::Array;
	Type.Element = &GetPropertyType<FElement>();
	Type.GetNum = [](const void* Address)
	{
		return static_cast<const T*>(Address)->Num();
	};
	Type.Reset = [](void* Address, int32 Num)
	{
		T& Array = *static_cast<T*>(Address);
		Array = T();
		for (int32 Index = 0; Index < Num; ++Index)
		{
			Array.Add(FElement());
		}
	};
	Type.GetElement = [](void* Address, int32 Index) -> void*
	{
		return static_cast<T*>(Address)->GetData() + Index;
	};
	return Type;
}

template<typename T>
FPropertyType MakePropertyType()
{
	FPropertyType Type;
	if constexpr (std::is_integral_v<T> || std::is_enum_v<T>)
	{
		Type.Kind = std::is_same_v<T, bool> ? EPropertyKind::Bool
					: std::is_enum_v<T>     ? EPropertyKind::Enum
											: EPropertyKind::Whole;
		Type.GetWhole = [](const void* Address)
		{
			return static_cast<int64>(*static_cast<const T*>(Address));
		};
		Type.SetWhole = [](void* Address, int64 Value)
		{
			*static_cast<T*>(Address) = static_cast<T>(Value);
		};
		if constexpr (std::is_enum_v<T>)
		{
			Type.Type = &typeid(T);
			SetWholeRange<std::underlying_type_t<T>>(Type);
		}
		else
		{
			SetWholeRange<T>(Type);
		}
	}
	else if constexpr (std::is_floating_point_v<T>)
	{
		Type.Kind = EPropertyKind::Real;
		Type.bFloat = std::is_same_v<T, float>;
		Type.GetReal = [](const void* Address, int32)
		{
			return static_cast<double>(*static_cast<const T*>(Address));
		};
		Type.SetReal = [](void* Address, int32, double Value)
		{
			*static_cast<T*>(Address) = static_cast<T>(Value);
		};
	}
	else if constexpr (std::is_same_v<T, FString> || std::is_same_v<T, FName>)
	{
		Type.Kind = EPropertyKind::Text;
		Type.GetText = [](const void* Address)
		{
			const T& Value = *static_cast<const T*>(Address);
			if constexpr (std::is_same_v<T, FName>)
			{
				return std::string(*Value.ToString());
			}
			else
			{
				return std::string(*Value);
			}
		};
		Type.SetText = [](void* Address, const std::string& Text)
		{
			*static_cast<T*>(Address) = T(Text.c_str());
		};
	}
	else if constexpr (CHasComponents<T>)
	{
		Type = MakeComponentsType<T>();
	}
	else if constexpr (!std::is_void_v<typename TArrayElementOf<T>::Type>)
	{
		Type = MakeArrayType<T>();
	}
	else if constexpr (!std::is_void_v<typename TPointee<T>::Type>)
	{
		Type = MakeObjectType<T>();
	}
	else if constexpr (std::is_class_v<T>)
	{
		Type.Kind = EPropertyKind::Struct;
		Type.Type = &typeid(T);
	}
	return Type;
}

template<typename T>
const FPropertyType& GetPropertyType()
{
	static const FPropertyType Type = MakePropertyType<T>();
	return Type;
}

template<typename T>
FReflectedStruct MakeReflectedStruct(const TCHAR* Name, const TCHAR* Module, const TCHAR* Config)
{
	FReflectedStruct Struct{.Name = Name, .Module = Module, .Config = Config, .Type = &typeid(T)};
	if constexpr (requires { typename T::Super; })
	{
		if constexpr (!std::is_same_v<typename T::Super, T>)
		{
			Struct.Super = &typeid(typename T::Super);
			Struct.ToSuper = [](void* Container) -> void*
			{
				return static_cast<typename T::Super*>(static_cast<T*>(Container));
			};
		}
	}
	if constexpr (std::is_base_of_v<UObject, T>)
	{
		T::StaticClass(); // which makes it: GetClass finds it before anybody asks
		Struct.FromObject = [](UObject* Object) -> void*
		{
			return static_cast<T*>(Object);
		};
		if constexpr (!std::is_abstract_v<T> && std::is_default_constructible_v<T>)
		{
			Struct.GetDefault = []() -> UObject*
			{
				return GetMutableDefault<T>();
			};
			if constexpr (requires { T::template PlaceInWorld<T>(); })
			{
				Struct.Place = []
				{
					T::template PlaceInWorld<T>();
				};
			}
		}
	}
	return Struct;
}

/** The call of a member or static function; Member: whether it is one. */
template<bool bMember, typename TClass, typename... TParameters>
struct TFunctionCall
{
	template<auto Function>
	static bool Call(void* Container, const std::vector<FPropertyValue>& Arguments, FPropertyProblem& OutProblem)
	{
		return Call<Function>(Container, Arguments, OutProblem, std::index_sequence_for<TParameters...>());
	}

private:
	template<typename T>
	static bool Write(T& Value, const FPropertyValue& Given, size_t Index, FPropertyProblem& OutProblem)
	{
		const FPropertyType& Type = GetPropertyType<T>();
		const bool bNull = Given.Kind == FPropertyValue::EKind::None && Type.Kind == EPropertyKind::Object;
		const bool bWritten = bNull || WriteProperty(Type, &Value, Given, OutProblem);
		if constexpr (std::is_pointer_v<T> && std::is_convertible_v<UObject*, T>)
		{
			Value = bNull ? GetWorldContext() : Value; // a Blueprint fills it in
		}
		OutProblem.Path.insert(0, bWritten ? "" : "/" + std::to_string(Index));
		return bWritten;
	}

	template<auto Function, size_t... Indices>
	static bool Call(void* Container, [[maybe_unused]] const std::vector<FPropertyValue>& Arguments,
		[[maybe_unused]] FPropertyProblem& OutProblem, std::index_sequence<Indices...>)
	{
		[[maybe_unused]] std::tuple<std::decay_t<TParameters>...> Values{};
		if (!(Write(std::get<Indices>(Values), Arguments[Indices], Indices, OutProblem) && ...))
		{
			return false;
		}
		if (Container != nullptr)
		{
			if constexpr (bMember)
			{
				(static_cast<TClass*>(Container)->*Function)(static_cast<TParameters&&>(std::get<Indices>(Values))...);
			}
			else
			{
				using TResult = decltype((*Function)(static_cast<TParameters&&>(std::get<Indices>(Values))...));
				const auto Do = [&]
				{
					return (*Function)(static_cast<TParameters&&>(std::get<Indices>(Values))...);
				};
				if constexpr (requires(TResult R) {
								  static_cast<UBlueprintAsyncActionBase*>(R);
								  R->Activate();
							  })
				{
					if (const TResult Action = Do()) // as a Blueprint does with what such a function returns
					{
						Action->Activate();
					}
				}
				else
				{
					Do();
				}
			}
		}
		return true;
	}
};

template<typename TResult, typename TClass, typename... TParameters>
TFunctionCall<true, TClass, TParameters...> GetFunctionCall(TResult (TClass::*)(TParameters...));
template<typename TResult, typename TClass, typename... TParameters>
TFunctionCall<true, TClass, TParameters...> GetFunctionCall(TResult (TClass::*)(TParameters...) const);
template<typename TResult, typename... TParameters>
TFunctionCall<false, void, TParameters...> GetFunctionCall(TResult (*)(TParameters...));

template<bool bMember, typename TClass, typename... TParameters>
consteval bool CanMakeArguments(const TFunctionCall<bMember, TClass, TParameters...>*)
{
	return (std::is_default_constructible_v<std::decay_t<TParameters>> && ...);
}
template<bool bMember, typename TClass, typename... TParameters>
consteval size_t CountParameters(const TFunctionCall<bMember, TClass, TParameters...>*)
{
	return sizeof...(TParameters);
}

/** Function: a pointer to it. One whose arguments nobody can make is left out. */
template<auto Function>
void AddReflectedFunction(FReflectedStruct& Struct, const TCHAR* Name)
{
	using FCall = decltype(GetFunctionCall(Function));
	constexpr const FCall* None = nullptr;
	if constexpr (CanMakeArguments(None))
	{
		Struct.Functions.push_back({Name, CountParameters(None), &FCall::template Call<Function>});
	}
}

/** Known for as long as the library is loaded. */
template<typename T>
class TReflectionRegistration : private FNoncopyable
{
public:
	explicit TReflectionRegistration(T InInfo)
		: Info(std::make_unique<T>(std::move(InInfo)))
	{
		FReflection::Get().Register(*Info);
	}
	~TReflectionRegistration() { FReflection::Get().Unregister(*Info); }

private:
	std::unique_ptr<T> Info;
};

} // namespace Drydock

// Generated code: BEGIN, a line for each property with the header's own #if around it, END. Private fields are reached
// because GENERATED_BODY makes Drydock::TReflected a friend.
#define DRYDOCK_REFLECT_BEGIN(Class, Module, Config) \
	template<> \
	struct Drydock::TReflected<Class> \
	{ \
		using FType = Class; \
		static ::Drydock::FReflectedStruct Make() \
		{ \
			::Drydock::FReflectedStruct Struct = \
				::Drydock::MakeReflectedStruct<Class>(TEXT(#Class), TEXT(Module), TEXT(Config));

#define DRYDOCK_REFLECT(Field, TypeName, bConfig) \
	Struct.Properties.push_back( \
		{TEXT(#Field), TEXT(TypeName), bConfig, &::Drydock::GetPropertyType<decltype(FType::Field)>(), \
			[](void* Container) -> void* \
			{ \
				return std::addressof(static_cast<FType*>(Container)->Field); \
			}});

#define DRYDOCK_REFLECT_BITS(Field, TypeName, bConfig, NumBits) \
	static const ::Drydock::FPropertyType TypeOf##Field = { \
		.Kind = NumBits == 1 ? ::Drydock::EPropertyKind::Bool : ::Drydock::EPropertyKind::Whole, \
		.GetWhole = [](const void* Container) \
		{ return static_cast<int64>(static_cast<const FType*>(Container)->Field); }, \
		.SetWhole = [](void* Container, int64 Value) \
		{ static_cast<FType*>(Container)->Field = static_cast<decltype(FType::Field)>(Value); }, \
		.Most = (int64(1) << NumBits) - 1}; \
	Struct.Properties.push_back({TEXT(#Field), TEXT(TypeName), bConfig, &TypeOf##Field, \
		[](void* Container) \
		{ \
			return Container; \
		}});

// One that has overloads is left out.
#define DRYDOCK_REFLECT_CALL(Function) \
	[&]<typename T>(const T*) \
	{ \
		if constexpr (requires { ::Drydock::GetFunctionCall(&T::Function); }) \
		{ \
			::Drydock::AddReflectedFunction<&T::Function>(Struct, TEXT(#Function)); \
		} \
	}(static_cast<const FType*>(nullptr));

#define DRYDOCK_REFLECT_END(Class) \
	return Struct; \
	} \
	} \
	; \
	static const ::Drydock::TReflectionRegistration<::Drydock::FReflectedStruct> GReflect##Class( \
		::Drydock::TReflected<Class>::Make());

#define DRYDOCK_REFLECT_ENUM_BEGIN(Enum, Id) \
	static const ::Drydock::TReflectionRegistration<::Drydock::FReflectedEnum> GReflect##Id({TEXT(#Id), &typeid(Enum), {

#define DRYDOCK_REFLECT_ENUMERATOR(Scope, Value) {TEXT(#Value), static_cast<int64>(Scope::Value)},

#define DRYDOCK_REFLECT_ENUM_END() \
	} \
	});
