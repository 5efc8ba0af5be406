// A store of structs by type that lives as long as its builder: lets distant parts of a frame share graph resources.
// Source: engine RenderGraphBlackboard.h.
#pragma once

#include "CoreMinimal.h"

#include <map>
#include <memory>
#include <string>

/** Declares a struct fit for the blackboard; at namespace scope, once per type. The name keeps types of different
 * shared objects apart or together. */
#define RDG_REGISTER_BLACKBOARD_STRUCT(StructType) \
	template<> \
	inline const TCHAR* FRDGBlackboard::GetTypeName<StructType>() \
	{ \
		return TEXT(#StructType); \
	}

class FRDGBlackboard
{
public:
	/** The type must be declared by RDG_REGISTER_BLACKBOARD_STRUCT. */
	template<typename StructType>
	static const TCHAR* GetTypeName()
	{
		static_assert(sizeof(StructType) == 0, "declare the type with RDG_REGISTER_BLACKBOARD_STRUCT");
		return nullptr;
	}

	/** A check when there is one already. The reference stays valid until the builder goes. */
	template<typename StructType, typename... ArgumentTypes>
	StructType& Create(ArgumentTypes&&... Arguments)
	{
		std::shared_ptr<void>& Slot = Structs[GetTypeName<StructType>()];
		checkf(!Slot, TEXT("RDGBlackboard duplicate %s: it was created already"), GetTypeName<StructType>());
		std::shared_ptr<StructType> Struct(new StructType{std::forward<ArgumentTypes>(Arguments)...});
		Slot = Struct;
		return *Struct;
	}

	/** Null when there is none. */
	template<typename StructType>
	const StructType* Get() const
	{
		const auto Found = Structs.find(GetTypeName<StructType>());
		return Found == Structs.end() ? nullptr : static_cast<const StructType*>(Found->second.get());
	}

	template<typename StructType>
	StructType* GetMutable() const
	{
		return const_cast<StructType*>(Get<StructType>());
	}

	template<typename StructType>
	const StructType& GetChecked() const
	{
		const StructType* Struct = Get<StructType>();
		checkf(Struct, TEXT("RDGBlackboard has no %s"), GetTypeName<StructType>());
		return *Struct;
	}

	template<typename StructType>
	StructType& GetMutableChecked() const
	{
		return const_cast<StructType&>(GetChecked<StructType>());
	}

	template<typename StructType, typename... ArgumentTypes>
	StructType& GetOrCreate(ArgumentTypes&&... Arguments)
	{
		StructType* Struct = GetMutable<StructType>();
		return Struct ? *Struct : Create<StructType>(std::forward<ArgumentTypes>(Arguments)...);
	}

private:
	std::map<std::string, std::shared_ptr<void>> Structs;
};
